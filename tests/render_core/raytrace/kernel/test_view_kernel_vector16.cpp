#include <gtest/gtest.h>

#include "tests/support/raytrace/kernel_check.hpp"

namespace tedavis::raytrace::test_view_kernel_vector16 {
namespace {

TEST(ViewKernelVector16, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_bits_of_both_surfaces<std::int16_t>(32);
    test_support::expect_bits_of_both_surfaces<float>(32);
}

}  // namespace
}  // namespace tedavis::raytrace::test_view_kernel_vector16
