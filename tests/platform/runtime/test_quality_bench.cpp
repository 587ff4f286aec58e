#include "platform/runtime/quality_bench.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/platform/runtime/modelled_bench.hpp"

namespace tedavis::platform::test_quality_bench {
namespace {

using effects::Effect;

TEST(QualityBench, CandidatesAreMeasuredFromTheDesignsOwnPictureOn) {
    ModelledBench bench;
    const auto frames = std::make_unique<BenchFrames>(bench, ModelledBench::place());
    effects::MeasuredCost cost;
    cost.name = "antialiasing";
    cost.ms = bench.costs.antialiasing_ms;
    effects::QualityCandidates candidates;
    const auto quality = std::make_unique<QualityBench>(bench, *frames, 1);
    ASSERT_EQ(quality->measure({&cost, 1}, candidates, 0, 1).message.view(), "");
    ASSERT_GE(candidates.size(), 24u);
    const effects::QualityLevel& own = candidates[0].level;
    EXPECT_TRUE(own.tau_factor == 1 && own.detail_factor == 1 && own.given_up.is_empty());
    EXPECT_EQ(own.error_color, 0);
    EXPECT_GT(own.error_px, 0);
    const effects::QualityLevel& least = candidates.back().level;
    EXPECT_EQ(least.tau_factor, 4);
    EXPECT_GE(least.error_px, own.error_px);
    EXPECT_GT(least.error_color, 0.01);
    EXPECT_TRUE(least.given_up.has(Effect::antialiasing));
    EXPECT_GE(own.ms, least.ms + bench.costs.antialiasing_ms - 1e-3) << "what was given up is saved";
    for (const effects::QualityCandidate& candidate : candidates)
        for (std::size_t e = 0; e < effects::kEffectCount; ++e)
            EXPECT_TRUE(!candidate.level.given_up.has(static_cast<Effect>(e)) ||
                        effects::row_of(static_cast<Effect>(e)).may_be_given_up);
}

TEST(QualityBench, WhatSavesMuchForLittleDifferenceIsGivenUpFirst) {
    using Embellishment = QualityBench::Embellishment;
    const Embellishment little{Effect::haze, true, 1, 2}, much{Effect::haze, true, 4, 2}, nothing{Effect::haze, true, 0, 0},
        free_of_change{Effect::haze, true, 3, 0};
    EXPECT_TRUE(QualityBench::comes_before(much, little));
    EXPECT_FALSE(QualityBench::comes_before(little, much));
    for (const Embellishment& other : {little, much}) {
        EXPECT_TRUE(QualityBench::comes_before(nothing, other)) << "it makes no difference";
        EXPECT_FALSE(QualityBench::comes_before(other, nothing));
    }
    EXPECT_TRUE(QualityBench::comes_before(free_of_change, nothing));
    EXPECT_FALSE(QualityBench::comes_before(nothing, nothing));
}

TEST(QualityBench, AStopEndsIt) {
    ModelledBench bench;
    bench.stopped_at = 2;
    const auto frames = std::make_unique<BenchFrames>(bench, ModelledBench::place());
    effects::QualityCandidates candidates;
    const auto quality = std::make_unique<QualityBench>(bench, *frames, 1);
    EXPECT_EQ(quality->measure({}, candidates, 0, 1).message.view(), "interrupted; nothing was written");
}

}  // namespace
}  // namespace tedavis::platform::test_quality_bench
