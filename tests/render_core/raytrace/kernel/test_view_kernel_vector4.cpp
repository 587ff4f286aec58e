#include <gtest/gtest.h>

#include "tests/support/raytrace/kernel_check.hpp"

namespace tedavis::raytrace::test_view_kernel_vector4 {
namespace {

TEST(ViewKernelVector4, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_bits_of_both_surfaces<std::int16_t>(4);
    test_support::expect_bits_of_both_surfaces<float>(4);
}

}  // namespace
}  // namespace tedavis::raytrace::test_view_kernel_vector4
