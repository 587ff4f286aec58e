#include "platform/runtime/bench_frames.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/platform/runtime/modelled_bench.hpp"

namespace tedavis::platform::test_bench_frames {
namespace {

using effects::Effect;
using effects::QualityLevel;

struct BenchFramesTest : testing::Test {
    BenchFramesTest() { bench.quality_picture(0, *picture); }
    std::uint64_t hash(std::size_t side) {
        std::vector<std::uint8_t> pixels(std::size_t{4} * ModelledBench::kWidth * ModelledBench::kHeight);
        double ms = 0;
        EXPECT_TRUE(frames->draw(side, 0, ms, pixels));
        return base::frame_hash(pixels.data(), ModelledBench::kWidth, ModelledBench::kHeight, true);
    }
    ModelledBench bench;
    std::unique_ptr<BenchPicture> picture = std::make_unique<BenchPicture>();
    std::unique_ptr<BenchFrames> frames = std::make_unique<BenchFrames>(bench, ModelledBench::place());
};

TEST_F(BenchFramesTest, ALevelIsDrawnAtItsErrorAndWithoutWhatItGivesUp) {
    ASSERT_FALSE(frames->open(*picture));
    const std::uint64_t whole = hash(0);
    const double tau_px = frames->display(0).record().terrain.tau_px;
    EXPECT_GT(frames->display(0).record().terrain.triangles, 0u);
    ASSERT_FALSE(frames->open(*picture, QualityLevel()));
    EXPECT_EQ(hash(1), whole) << "the level of the design's own picture";
    frames->level(1)->given_up.add(Effect::antialiasing);
    EXPECT_NE(hash(1), whole);
    ASSERT_FALSE(frames->open(*picture, QualityLevel{2.5, 1, {}, 0, 0, 0}));
    static_cast<void>(hash(2));
    EXPECT_NEAR(frames->display(2).record().terrain.tau_px, 2.5 * tau_px, 1e-9);
}

TEST_F(BenchFramesTest, EverySideHasTheRoundsAndWhatItCosts) {
    ASSERT_FALSE(frames->open(*picture));
    effects::EffectSet given_up;
    given_up.add(Effect::antialiasing);
    frames->share(given_up);
    ASSERT_TRUE(frames->take_times(5));
    ASSERT_EQ(frames->ms(0).size(), 5u);
    EXPECT_NEAR(frames->cost_between(0, 1).ms, bench.costs.antialiasing_ms, 1e-3);
    EXPECT_EQ(frames->cost_between(1, 0).ms, 0) << "never below nothing";
    EXPECT_NEAR(frames->median_ms(0) - frames->median_ms(1), bench.costs.antialiasing_ms, 1e-3);
    frames->close();
    EXPECT_EQ(frames->sides(), 0u);
}

TEST_F(BenchFramesTest, ALostSurfaceAndAStopAreFaultsThatStay) {
    ASSERT_FALSE(frames->open(*picture));
    bench.lost_at = 3;
    EXPECT_FALSE(frames->take_times(5));
    EXPECT_EQ(frames->fault().message.view(), "the drawing surface was lost; start the command again");
    EXPECT_EQ(bench.drawn, 3);
    double ms = 0;
    EXPECT_FALSE(frames->draw(0, 0, ms));
    EXPECT_TRUE(frames->open(*picture)) << "and nothing is opened";
    frames = std::make_unique<BenchFrames>(bench, ModelledBench::place());
    ASSERT_FALSE(frames->open(*picture));
    bench.stopped_at = 4;
    EXPECT_FALSE(frames->take_times(5));
    EXPECT_EQ(frames->fault().message.view(), "interrupted; nothing was written");
}

TEST_F(BenchFramesTest, WhatCannotBeOpenedSaysWhy) {
    bench.terrain = "/nowhere.tdb";
    EXPECT_NE(frames->open(*picture).message.view().find("/nowhere.tdb"), std::string_view::npos);
    EXPECT_EQ(frames->sides(), 0u);
    EXPECT_FALSE(frames->fault()) << "another one may be";
}

}  // namespace
}  // namespace tedavis::platform::test_bench_frames
