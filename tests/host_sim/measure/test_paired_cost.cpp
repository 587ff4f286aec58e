#include "host_sim/measure/paired_cost.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_paired_cost {
namespace {

TEST(PairedCostOfLists, IsThatOfTheCore) {
    const std::vector<double> with_ms{5, 9, 7, 40}, without_ms{3, 5, 6};
    std::vector<double> room(4);
    const effects::PairedCost of_core =
        effects::paired_cost({with_ms.data(), with_ms.size()}, {without_ms.data(), without_ms.size()}, room);
    EXPECT_EQ(paired_cost(with_ms, without_ms).ms, of_core.ms);
    EXPECT_EQ(paired_cost(with_ms, without_ms).spread_ms, of_core.spread_ms);
    EXPECT_EQ(of_core.ms, 2);
    EXPECT_EQ(paired_cost({}, {}).ms, 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_paired_cost
