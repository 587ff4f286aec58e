// Checkpoints: the right one for an instant, exactly as it was, and never more of them than allowed.
#include "host_sim/replay/checkpoint_track.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_checkpoint_track {
namespace {

base::Time at(std::int64_t seconds) { return base::Time{} + base::Duration::seconds(seconds); }

FlightProgress progress_at(std::int64_t seconds, std::uint64_t offset, std::uint64_t steps) {
    FlightProgress progress;
    progress.reached = at(seconds);
    progress.position.offset = offset;
    progress.steps_run = steps;
    progress.next_edge = static_cast<std::size_t>(1000 + seconds);
    return progress;
}

TEST(CheckpointTrack, TakesTheFirstAndThenOneASpacing) {
    CheckpointTrack track(CheckpointSpacing{100, 10, 64});
    track.offer(progress_at(0, 0, 0));
    track.offer(progress_at(1, 99, 9));
    EXPECT_EQ(track.checkpoints().size(), 1u);
    track.offer(progress_at(2, 100, 9));   // by bytes
    track.offer(progress_at(3, 101, 19));  // by steps
    EXPECT_EQ(track.checkpoints().size(), 3u);
    track.offer(progress_at(2, 500, 500));  // played again after going back
    track.offer(progress_at(3, 500, 500));
    EXPECT_EQ(track.checkpoints().size(), 3u);
}

TEST(CheckpointTrack, FindsTheLastOneAtOrBefore) {
    CheckpointTrack track(CheckpointSpacing{100, 10, 64});
    for (std::int64_t n = 0; n < 5; ++n) track.offer(progress_at(10 * n, 100 * static_cast<std::uint64_t>(n), 0));
    EXPECT_EQ(track.reached_by(at(20)), at(20));
    EXPECT_EQ(track.reached_by(at(19)), at(10));
    EXPECT_EQ(track.reached_by(at(1000)), at(40));
    EXPECT_EQ(track.reached_by(at(-5)), at(0)) << "the first serves everything before";
    const FlightProgress progress = track.unpack(at(29));
    EXPECT_EQ(progress.next_edge, 1020u);
    EXPECT_EQ(progress.position.offset, 200u);
}

TEST(CheckpointTrack, StaysWithinItsBoundAndEven) {
    CheckpointTrack track(CheckpointSpacing{100, std::numeric_limits<std::uint64_t>::max(), 16});
    for (std::int64_t n = 0; n < 10000; ++n) {
        track.offer(progress_at(n, 25 * static_cast<std::uint64_t>(n), 0));
        ASSERT_LE(track.checkpoints().size(), 16u);
    }
    EXPECT_GE(track.checkpoints().size(), 8u);
    EXPECT_EQ(track.stride(), 256u) << "16 checkpoints of 256 spacings hold 10000 offers of a quarter spacing";
    EXPECT_EQ(track.checkpoints()[0].reached, at(0));
    for (std::size_t n = 1; n < track.checkpoints().size(); ++n)
        EXPECT_EQ(track.checkpoints()[n].log_offset - track.checkpoints()[n - 1].log_offset, 256u * 100u);
}

TEST(CheckpointTrack, GoesOnWhereAnEarlierTrackEnded) {
    const CheckpointSpacing spacing{100, std::numeric_limits<std::uint64_t>::max(), 4};
    CheckpointTrack whole(spacing), part(spacing);
    for (std::uint64_t n = 0; n < 9; ++n) part.offer(progress_at(static_cast<std::int64_t>(n), 100 * n, 0));
    CheckpointTrack rest(spacing, part.stride(), part.checkpoints());
    for (std::uint64_t n = 0; n < 30; ++n) whole.offer(progress_at(static_cast<std::int64_t>(n), 100 * n, 0));
    for (std::uint64_t n = 9; n < 30; ++n) rest.offer(progress_at(static_cast<std::int64_t>(n), 100 * n, 0));
    ASSERT_EQ(rest.checkpoints().size(), whole.checkpoints().size());
    for (std::size_t n = 0; n < whole.checkpoints().size(); ++n)
        EXPECT_EQ(rest.checkpoints()[n].reached, whole.checkpoints()[n].reached);
}

TEST(CheckpointTrack, DropsWhatLiesLaterButNeverTheFirst) {
    CheckpointTrack track(CheckpointSpacing{100, 10, 64});
    for (std::int64_t n = 0; n < 5; ++n) track.offer(progress_at(10 * n, 100 * static_cast<std::uint64_t>(n), 0));
    track.drop_after(at(20));
    EXPECT_EQ(track.checkpoints().size(), 3u);
    track.drop_after(at(-1));
    EXPECT_EQ(track.checkpoints().size(), 1u);
}

TEST(CheckpointTrack, PacksWell) {
    CheckpointTrack track;
    FlightProgress progress;
    progress.tracker.assembler = bus::StateAssembler();
    track.offer(progress);
    EXPECT_LT(track.checkpoints()[0].bytes.size(), sizeof(FlightProgress) / 4);
}

TEST(CheckpointTrack, RefusesDamagedBytes) {
    CheckpointTrack good;
    good.offer(progress_at(0, 0, 0));
    for (const std::string& bytes : {std::string("rubbish"), std::string(), good.checkpoints()[0].bytes.substr(0, 40)}) {
        const CheckpointTrack track({}, 1, {PackedCheckpoint{at(0), 0, 0, bytes}});
        test_support::expect_user_error([&] { static_cast<void>(track.unpack(at(0))); }, "damaged");
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_checkpoint_track
