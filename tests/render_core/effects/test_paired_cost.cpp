#include "render_core/effects/paired_cost.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace tedavis::effects::test_paired_cost {
namespace {

PairedCost paired(const std::vector<double>& with_ms, const std::vector<double>& without_ms) {
    std::array<double, 64> room{};
    return paired_cost({with_ms.data(), with_ms.size()}, {without_ms.data(), without_ms.size()}, {room.data(), room.size()});
}
double median(const std::vector<double>& values) {
    std::array<double, 64> room{};
    return median_of({values.data(), values.size()}, {room.data(), room.size()});
}
CostSlope slope(const std::vector<CostPoint>& points) { return cost_slope({points.data(), points.size()}); }

TEST(PairedCost, IsTheMedianOfDifferencesWhateverTheMachineDrifts) {
    std::vector<double> with_ms, without_ms;
    for (int n = 0; n < 21; ++n) {
        const double drift = 10 + n * n * 0.3;
        without_ms.push_back(drift);
        with_ms.push_back(drift + 2.5 + (n % 3 - 1) * 0.1);
    }
    with_ms[4] += 400;  // somebody else took the processor
    const PairedCost cost = paired(with_ms, without_ms);
    EXPECT_NEAR(cost.ms, 2.5, 0.11);
    EXPECT_LT(cost.spread_ms, 0.3);
    EXPECT_GT(std::abs(median(with_ms) - without_ms.front()), 20) << "control: unpaired it would drown";
}

TEST(PairedCost, IsNeverBelowNothing) {
    EXPECT_EQ(paired({1, 2, 3}, {5, 5, 5}).ms, 0);
    EXPECT_EQ(paired({}, {}).ms, 0);
    EXPECT_EQ(paired({7}, {4}).ms, 3);
    EXPECT_EQ(paired({7, 100}, {4}).ms, 3) << "what has no partner is left out";
}

TEST(PairedCost, MedianOfEvenAndOddCounts) {
    EXPECT_EQ(median({}), 0);
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
}

TEST(CostSlope, FindsWhatAThingCosts) {
    const CostSlope line = slope({{1000, 7}, {2000, 9}, {5000, 15}});
    EXPECT_NEAR(line.slope, 0.002, 1e-12);
    EXPECT_NEAR(line.offset, 5, 1e-9);
    EXPECT_EQ(slope({{1000, 9}, {2000, 7}}).slope, 0) << "more of it is never cheaper";
    EXPECT_EQ(slope({{1000, 9}, {2000, 7}}).offset, 8);
    EXPECT_EQ(slope({{5, 4}, {5, 6}}).offset, 5);
    EXPECT_EQ(slope({}).offset, 0);
}

}  // namespace
}  // namespace tedavis::effects::test_paired_cost
