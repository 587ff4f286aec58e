#include <gtest/gtest.h>

#include "tests/render_core/raytrace/kernel/paged_check.hpp"

namespace tedavis::raytrace::test_packet_kernel_scalar {
namespace {

TEST(PacketKernelScalar, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_paged_bits<std::int16_t>(1);
    test_support::expect_paged_bits<float>(1);
}

}  // namespace
}  // namespace tedavis::raytrace::test_packet_kernel_scalar
