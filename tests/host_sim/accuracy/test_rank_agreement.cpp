#include "host_sim/accuracy/rank_agreement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_rank_agreement {
namespace {

using ::testing::HasSubstr;

MeasuredKnob knob_of(const std::vector<double>& medians_ms, double noise = 0.02) {
    MeasuredKnob knob;
    knob.name = "made";
    knob.noise = noise;
    for (const double ms : medians_ms) {
        MeasuredLevel level;
        level.name = std::to_string(knob.levels.size());
        level.ms.median = ms;
        knob.levels.push_back(level);
    }
    return knob;
}

RankAgreement between(const MeasuredKnob& now, const MeasuredKnob& then) {
    RankAgreement ranks;
    ranks.add(now, then);
    return ranks;
}

TEST(RankAgreement, IsOneForTheSameOrderAndMinusOneForTheOpposite) {
    const MeasuredKnob rising = knob_of({1, 2, 3, 4}), falling = knob_of({4, 3, 2, 1});
    EXPECT_EQ(between(rising, rising).pairs, 6u);
    EXPECT_EQ(between(rising, rising).tau(), 1.0);
    EXPECT_EQ(between(rising, falling).tau(), -1.0) << "control";
    EXPECT_NEAR(between(rising, knob_of({1, 2, 4, 3})).tau().value(), 2.0 / 3, 1e-12) << "5 alike, 1 not, of 6 (Kendall 1938)";
}

TEST(RankAgreement, CountsNoPairThatTheNoiseOfARunHides) {
    const MeasuredKnob clear = knob_of({1, 2, 3}), noisy = knob_of({3, 2, 1}, 9);
    EXPECT_EQ(between(clear, noisy).pairs, 0u);
    EXPECT_FALSE(between(clear, noisy).tau().has_value());
    EXPECT_THAT(rank_text(between(clear, noisy)), HasSubstr("The noise hides all ranks from one"));
    EXPECT_EQ(between(clear, noisy).ranked, 3u) << "the newer run ranks them";
    EXPECT_EQ(between(noisy, clear).ranked, 0u) << "control";
}

TEST(RankAgreement, OnlyClearlyDifferentMediansShouldBeRanked) {
    const RankAgreement ranks = between(knob_of({1, 1.05, 2}, 0.03), knob_of({1, 1.05, 2}, 0.03));
    EXPECT_EQ(ranks.distinct, 2u) << "1 and 1.05 differ by 5 %";
    EXPECT_EQ(ranks.ranked, 2u);
    EXPECT_EQ(ranks.pairs, 3u);
    EXPECT_THAT(rank_text(ranks), HasSubstr("Both rank 3 pairs of levels, 3 of them alike (Kendall's tau 1.000). Of 2 pairs"));
}

TEST(RankAgreement, ComparesOnlyLevelsThatBothHave) {
    EXPECT_EQ(between(knob_of({1, 2, 3}), knob_of({1, 2})).pairs, 1u);
    EXPECT_THAT(rank_text(between(knob_of({1}), knob_of({1, 2}))), HasSubstr("no two levels of a setting in common"));
    RankAgreement two = between(knob_of({1, 2}), knob_of({1, 2}));
    two.add(knob_of({2, 1}), knob_of({1, 2}));
    EXPECT_EQ(two.tau(), 0.0) << "knobs add up";
}

}  // namespace
}  // namespace tedavis::host_sim::test_rank_agreement
