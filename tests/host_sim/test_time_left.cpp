#include "host_sim/time_left.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_time_left {
namespace {

TEST(TimeLeft, IsTheRestAtThePaceSoFar) {
    EXPECT_EQ(time_left(10, 0.5), "10 s left");
    EXPECT_EQ(time_left(10, 0.1), "90 s left");
    EXPECT_EQ(time_left(60, 0.25), "3 min left");
    EXPECT_EQ(time_left(100, 0.5), "2 min left") << "rounded up";
    EXPECT_EQ(time_left(3600, 0.5), "1 h 00 min left");
    EXPECT_EQ(time_left(3600, 0.48), "1 h 05 min left");
    EXPECT_EQ(time_left(60, 1), "0 s left");
}

TEST(TimeLeft, SaysNothingWhereItCannotBeTold) {
    EXPECT_EQ(time_left(1.9, 0.5), "");
    EXPECT_EQ(time_left(100, 0), "");
    EXPECT_EQ(time_left(100, 1e-12), "");
    EXPECT_EQ(time_left(100, std::nan("")), "");
    EXPECT_EQ(time_left(60, 1.5), "0 s left") << "more than all is all";
}

}  // namespace
}  // namespace tedavis::host_sim::test_time_left
