#include <gtest/gtest.h>

#include "tests/support/raytrace/kernel_check.hpp"

namespace tedavis::raytrace::test_view_kernel_vector8 {
namespace {

TEST(ViewKernelVector8, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_bits_of_both_surfaces<std::int16_t>(8);
    test_support::expect_bits_of_both_surfaces<float>(8);
}

}  // namespace
}  // namespace tedavis::raytrace::test_view_kernel_vector8
