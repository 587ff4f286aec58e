#include <gtest/gtest.h>

#include "tests/render_core/raytrace/kernel/paged_check.hpp"

namespace tedavis::raytrace::test_packet_kernel_vector16 {
namespace {

TEST(PacketKernelVector16, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_paged_bits<std::int16_t>(32);
    test_support::expect_paged_bits<float>(32);
}

}  // namespace
}  // namespace tedavis::raytrace::test_packet_kernel_vector16
