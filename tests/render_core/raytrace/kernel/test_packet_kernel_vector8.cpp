#include <gtest/gtest.h>

#include "tests/render_core/raytrace/kernel/paged_check.hpp"

namespace tedavis::raytrace::test_packet_kernel_vector8 {
namespace {

TEST(PacketKernelVector8, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_paged_bits<std::int16_t>(8);
    test_support::expect_paged_bits<float>(8);
}

}  // namespace
}  // namespace tedavis::raytrace::test_packet_kernel_vector8
