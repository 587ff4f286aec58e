#include "host_sim/replay/bench_frames.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_bench_frames {
namespace {

BenchPlace place() {
    static const test_support::FlownFiles kFiles;
    BenchPlace place{kFiles.options("unused").picture, {47.03, 9.68, 2500, 40, -6, 0}};
    place.picture.size = PictureSize{96, 64};
    place.pose.time = kPosedTime;
    return place;
}

TEST(BenchFrames, ALevelIsDrawnAtItsErrorAndWithoutWhatItGivesUp) {
    PictureOptions picture = place().picture;
    picture.with.add(effects::Effect::antialiasing);
    BenchSide own = open_bench_side(place(), picture);
    EXPECT_GT(bench_frame_ms(place(), own, 0), 0);
    const std::uint64_t whole = own.session->frame_hash();
    const double tau_px = own.session->display().record().terrain.tau_px;
    BenchSide alike = open_bench_side(place(), picture, effects::QualityLevel());
    static_cast<void>(bench_frame_ms(place(), alike, 0));
    EXPECT_EQ(alike.session->frame_hash(), whole) << "the level of the design's own picture";
    alike.level->given_up.add(effects::Effect::antialiasing);
    static_cast<void>(bench_frame_ms(place(), alike, 0));
    EXPECT_NE(alike.session->frame_hash(), whole);
    BenchSide coarse = open_bench_side(place(), picture, effects::QualityLevel{2.5, 1, {}, 0, 0, 0});
    static_cast<void>(bench_frame_ms(place(), coarse, 0));
    EXPECT_NEAR(coarse.session->display().record().terrain.tau_px, 2.5 * tau_px, 1e-9);
}

TEST(BenchFrames, EverySideHasTheRounds) {
    std::vector<BenchSide> sides{open_bench_side(place(), place().picture)};
    sides.push_back(sides.front());
    const std::vector<std::vector<double>> ms = bench_frames_ms(place(), sides, 3);
    ASSERT_EQ(ms.size(), 2u);
    for (const std::vector<double>& of_side : ms) {
        EXPECT_EQ(of_side.size(), 3u);
        for (const double one : of_side) EXPECT_GT(one, 0);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_bench_frames
