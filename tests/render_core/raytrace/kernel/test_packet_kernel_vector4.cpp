#include <gtest/gtest.h>

#include "tests/render_core/raytrace/kernel/paged_check.hpp"

namespace tedavis::raytrace::test_packet_kernel_vector4 {
namespace {

TEST(PacketKernelVector4, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_paged_bits<std::int16_t>(4);
    test_support::expect_paged_bits<float>(4);
}

}  // namespace
}  // namespace tedavis::raytrace::test_packet_kernel_vector4
