#include "host_sim/replay/quality_bench.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_quality_bench {
namespace {

TEST(QualityBench, CandidatesAreMeasuredFromTheDesignsOwnPictureOn) {
    const test_support::FlownFiles files;
    BenchPlace place{files.options("unused").picture, {47.03, 9.68, 2500, 40, -6, 0}};
    place.picture.size = PictureSize{96, 64};
    place.pose.time = kPosedTime;
    std::size_t pictures = 0;
    const std::vector<QualityCandidate> candidates =
        QualityBench(place, 1).measure({{"antialiasing", {}, 5, 0, "", ""}}, [&] { ++pictures; });
    EXPECT_EQ(pictures, QualityBench::kPictures);
    ASSERT_GE(candidates.size(), 12u);
    const effects::QualityLevel& own = candidates.front().level;
    EXPECT_TRUE(own.tau_factor == 1 && own.detail_factor == 1 && own.given_up.is_empty());
    EXPECT_EQ(own.error_color, 0);
    EXPECT_GT(own.error_px, 0);
    const effects::QualityLevel& least = candidates.back().level;
    EXPECT_EQ(least.tau_factor, 4);
    EXPECT_GE(least.error_px, own.error_px);
    EXPECT_GT(least.error_color, 0.01);
    EXPECT_TRUE(least.given_up.has(effects::Effect::antialiasing));
    for (const QualityCandidate& candidate : candidates) {
        EXPECT_GT(candidate.level.ms, 0);
        for (std::size_t e = 0; e < effects::kEffectCount; ++e) {
            const auto effect = static_cast<effects::Effect>(e);
            EXPECT_TRUE(!candidate.level.given_up.has(effect) || effects::row_of(effect).may_be_given_up);
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_quality_bench
