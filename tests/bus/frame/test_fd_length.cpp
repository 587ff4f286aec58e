#include "bus/frame/fd_length.hpp"

#include <gtest/gtest.h>

#include <set>

namespace tedavis::bus::test_fd_length {
namespace {

TEST(FdLength, AreTheSixteenOfTheStandard) {
    const std::set<std::size_t> expected{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};
    for (std::size_t length = 0; length < 200; ++length) EXPECT_EQ(is_fd_length(length), expected.count(length) == 1) << length;
}

}  // namespace
}  // namespace tedavis::bus::test_fd_length
