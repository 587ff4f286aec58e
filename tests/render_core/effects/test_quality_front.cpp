#include "render_core/effects/quality_front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <random>

namespace tedavis::effects::test_quality_front {
namespace {

QualityCandidate candidate(double tau, double detail, double ms, double error_px, double error_color, double spread_ms = 0) {
    return {{tau, detail, {}, ms, error_px, error_color}, spread_ms};
}

QualityCandidates list(std::initializer_list<QualityCandidate> candidates) {
    QualityCandidates all;
    for (const QualityCandidate& one : candidates) static_cast<void>(all.try_push_back(one));
    return all;
}

TEST(QualityFront, LeavesOutWhatIsDominatedAndWhatLooksAlike) {
    const QualityCandidates front = pareto_front(list({candidate(1, 1, 40, 1, 0),         // the design's own picture
                                                       candidate(1, 0.5, 39, 1, 0),       // the same picture: noise
                                                       candidate(2, 1, 30, 2, 1),         //
                                                       candidate(2, 0.5, 32, 2, 1.5),     // dominated
                                                       candidate(4, 1, 20, 4, 2),         //
                                                       candidate(4, 0.5, 25, 4, 1.5)}));  //
    ASSERT_EQ(front.size(), 4u);
    EXPECT_EQ(front[0].level.ms, 40);
    EXPECT_EQ(front[1].level.ms, 30);
    EXPECT_EQ(front[2].level.ms, 25);
    EXPECT_EQ(front[3].level.ms, 20);
    EXPECT_TRUE(pareto_front({}).empty());
}

TEST(QualityFront, TheDesignsOwnPictureStaysAlthoughAnotherWasQuicker) {
    const QualityLevels levels = choose_levels(list({candidate(1, 1, 40, 1, 0), candidate(2, 1, 41, 2, 1)}));
    EXPECT_EQ(levels.count, 1u) << "nothing saves time";
    EXPECT_EQ(levels.at[0].ms, 40);
    EXPECT_EQ(choose_levels({}).count, 1u);
}

TEST(QualityFront, ALevelSavesMoreThanTheNoise) {
    EXPECT_EQ(choose_levels(list({candidate(1, 1, 40, 1, 0), candidate(2, 1, 38, 2, 1, 3)})).count, 1u);
    EXPECT_EQ(choose_levels(list({candidate(1, 1, 40, 1, 0), candidate(2, 1, 38, 2, 1, 1)})).count, 2u);
}

/// The cheaper of two that are cheap enough is not chosen where the other looks more like the design's picture.
TEST(QualityFront, PrefersTheSmallerDifferenceOfColor) {
    const QualityLevels levels = choose_levels(list(
        {candidate(1, 1, 64, 1, 0), candidate(1, 0.5, 31, 1, 3), candidate(2, 1, 31.5, 2, 0.5), candidate(4, 0.2, 2, 4, 4)}));
    ASSERT_EQ(levels.count, 3u);
    EXPECT_EQ(levels.at[1].error_color, 0.5);
    EXPECT_EQ(levels.at[2].ms, 2);
}

/// Whatever was measured, what is chosen can be read back; and the cheapest candidates are used.
TEST(QualityFront, RandomMeasurementsGiveLevelsWithoutFault) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> noise(0.7, 1.3);
    std::size_t most = 0, unfit = 0;
    for (int n = 0; n < 500; ++n) {
        QualityCandidates candidates;
        QualityLevels all;
        for (const double tau : {1.0, 1.6, 2.5, 4.0})
            for (const double detail : {1.0, 0.5, 0.2}) {
                const double ms = noise(random) * (20 / tau + 20 * detail);
                const bool is_own = tau == 1 && detail == 1;
                static_cast<void>(candidates.try_push_back(
                    candidate(tau, detail, ms, tau, is_own ? 0 : noise(random) * (tau - detail), noise(random))));
            }
        const QualityLevels levels = choose_levels(candidates);
        for (std::size_t level = 0; level < levels.count; ++level) ASSERT_EQ(fault_of(levels, level), "") << n;
        most = std::max<std::size_t>(most, levels.count);
        for (std::size_t k = 0; k < kQualityLevelCount; ++k) all.at[k] = candidates[2 * k].level;
        for (std::size_t k = 0; k < kQualityLevelCount; ++k) unfit += fault_of(all, k).empty() ? 0 : 1;
    }
    EXPECT_GE(most, 5u);
    EXPECT_GT(unfit, 500u) << "control: candidates taken as they come would be refused";
}

}  // namespace
}  // namespace tedavis::effects::test_quality_front
