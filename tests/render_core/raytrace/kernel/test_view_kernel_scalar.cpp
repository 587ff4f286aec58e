#include <gtest/gtest.h>

#include "tests/support/raytrace/kernel_check.hpp"

namespace tedavis::raytrace::test_view_kernel_scalar {
namespace {

TEST(ViewKernelScalar, FindsWhatSingleRaysFindBitForBit) {
    test_support::expect_bits_of_both_surfaces<std::int16_t>(1);
    test_support::expect_bits_of_both_surfaces<float>(1);
}

}  // namespace
}  // namespace tedavis::raytrace::test_view_kernel_scalar
