#include "host_sim/terrain_builder/attributes/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tedavis::host_sim::test_lanes {
namespace {

TEST(Lanes, ArcTangentIsThatOfLongDouble) {
    double worst = 0;
    for (double t = 1e-6; t < 1e7; t *= 1.0007) {
        const auto tangent = static_cast<float>(t);
        const Lanes angle = arc_tangent(Lanes{tangent, -tangent, 0, 1});
        worst = std::max(worst, std::abs(static_cast<double>(angle[0] - std::atan(static_cast<long double>(tangent)))));
        ASSERT_EQ(angle[0], -angle[1]);
        ASSERT_EQ(angle[2], 0);
    }
    EXPECT_LT(worst, 2e-7);
    EXPECT_GT(worst, 1e-12) << "the comparison sees the difference of float and long double";
}

TEST(Lanes, LanesDoNotMix) {
    const Lanes a{1, -2, 9, 0}, b{2, -3, 4, 0};
    const Lanes high = larger(a, b), low = smaller(a, b), roots = root(Lanes{1, 4, 9, 0}), size = size_of(a);
    for (int n = 0; n < kLanes; ++n) {
        EXPECT_EQ(high[n], std::max(a[n], b[n]));
        EXPECT_EQ(low[n], std::min(a[n], b[n]));
        EXPECT_EQ(roots[n], static_cast<float>(n < 3 ? n + 1 : 0));
        EXPECT_EQ(size[n], std::abs(a[n]));
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_lanes
