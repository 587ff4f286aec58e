// A run that begins late draws the frames of the whole run, also from what an earlier one has left beside the log.
#include "host_sim/replay/interval_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "host_sim/replay/frame_instants.hpp"
#include "host_sim/replay/run_recorder.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_interval_store {
namespace {

/// An index of so small a log is kept, too.
IndexPolicy always_kept() {
    IndexPolicy policy;
    policy.smallest_kept_log = 0;
    policy.rest = base::Duration{-1'000'000'000'000};
    return policy;
}

struct Drawn {
    std::uint64_t hash = 0;
    std::int64_t undecided = 0;  ///< before the frame
};

/// The frame at a time of a run that begins with it.
Drawn draw_at(const ReplayOptions& options, double time_s) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    DisplaySession session(options.picture, false);
    FlightPlayer player(player_files(options), session.display(), nullptr, always_kept());
    FramePreroll preroll(player, session, session.device().frame_rate_hz);
    const IntervalStore store(options, session, player, preroll, console);
    const base::Time time = player.first() + base::Duration::from_seconds(time_s);
    Drawn drawn;
    drawn.undecided = preroll.undecided_before(time);
    EXPECT_TRUE(preroll.preroll(time));
    const flight::FrameInput input = player.at(time);
    session.display().plan({input.state, input.phase, time, input.trail, input.legend});
    session.draw();
    drawn.hash = session.frame_hash();
    return drawn;
}

struct Flown {
    test_support::FlownFiles files{test_support::FlownCircle()};
    ReplayOptions options = files.options("run");
    std::string kept = options.log + ".tdi";
};

TEST(IntervalStore, ALaterRunGoesOnFromWhatAnEarlierOneDecided) {
    Flown flown;
    const Drawn first = draw_at(flown.options, 8);
    ASSERT_TRUE(std::filesystem::exists(flown.kept));
    const Drawn again = draw_at(flown.options, 8);
    EXPECT_EQ(again.hash, first.hash);
    EXPECT_GT(first.undecided, 15);
    EXPECT_LT(again.undecided, IntervalTrack::kEvery);
}

TEST(IntervalStore, AnotherDisplayTakesNothingOfIt) {
    Flown flown;
    const Drawn first = draw_at(flown.options, 8);
    ReplayOptions other = flown.options;
    other.picture.size = PictureSize{200, 160};
    EXPECT_EQ(draw_at(other, 8).undecided, first.undecided);
    EXPECT_EQ(draw_at(flown.options, 8).undecided, first.undecided) << "the other one has taken its place";
    EXPECT_LT(draw_at(flown.options, 8).undecided, first.undecided) << "control";
}

TEST(IntervalStore, NothingIsKeptWithoutAnIndexOrWithADeadline) {
    Flown flown;
    ReplayOptions without = flown.options;
    without.keeps_index = false;
    static_cast<void>(draw_at(without, 2));
    EXPECT_FALSE(std::filesystem::exists(flown.kept));
    ReplayOptions held = flown.options;
    held.picture.deadline_ms = 1000;
    static_cast<void>(draw_at(held, 2));
    EXPECT_FALSE(std::filesystem::exists(flown.kept));
}

TEST(IntervalStore, ADamagedFileIsMadeAnew) {
    Flown flown;
    const Drawn first = draw_at(flown.options, 8);
    std::ofstream(flown.kept, std::ios::binary) << "no intervals";
    const Drawn again = draw_at(flown.options, 8);
    EXPECT_EQ(again.hash, first.hash);
    EXPECT_EQ(again.undecided, first.undecided);
    EXPECT_LT(draw_at(flown.options, 8).undecided, first.undecided);
}

}  // namespace
}  // namespace tedavis::host_sim::test_interval_store
