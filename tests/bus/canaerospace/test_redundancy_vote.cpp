#include "bus/canaerospace/redundancy_vote.hpp"

#include <gtest/gtest.h>

namespace tedavis::bus::test_redundancy_vote {
namespace {

using base::Duration;
using base::Quality;
using base::Stamped;

constexpr base::FreshnessLimits kLimits{Duration::milliseconds(300), Duration::seconds(1)};
constexpr base::Time kNow{10'000'000'000};

Stamped<double> aged(std::int64_t ms, Quality quality = Quality::good) {
    return {1.0, kNow - Duration::milliseconds(ms), quality};
}

std::size_t winner(Stamped<double> a, Stamped<double> b) {
    const Stamped<double> both[] = {a, b};
    return vote(both, kNow, kLimits);
}

TEST(RedundancyVote, OrderOfBelief) {
    const Stamped<double> order[] = {aged(10), aged(10, Quality::degraded), aged(500), aged(10, Quality::bad), aged(5000), {}};
    for (std::size_t better = 0; better < 6; ++better)
        for (std::size_t worse = better + 1; worse < 6; ++worse) {
            EXPECT_EQ(winner(order[better], order[worse]), 0u) << better << " against " << worse;
            EXPECT_EQ(winner(order[worse], order[better]), 1u) << better << " against " << worse;
        }
}

TEST(RedundancyVote, TheFirstAmongEqualsEvenIfOlder) {
    EXPECT_EQ(winner(aged(200), aged(10)), 0u);
    EXPECT_EQ(winner({}, {}), 0u);
    EXPECT_EQ(vote({}, kNow, kLimits), 0u);
}

}  // namespace
}  // namespace tedavis::bus::test_redundancy_vote
