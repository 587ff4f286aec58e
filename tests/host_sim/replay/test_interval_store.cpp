// A run that begins late draws the frames of the whole run, also from what an earlier one has left beside the log.
#include "host_sim/replay/interval_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
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

/// The frame at a time of a run that begins with it. `meanwhile` is done once the display has loaded its files.
Drawn draw_at(
    const ReplayOptions& options, double time_s, const std::function<void()>& meanwhile = [] {}) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    const std::optional<DisplayFiles> files = IntervalStore::files_before_start(options);
    DisplaySession session(options.picture, false);
    meanwhile();
    FlightPlayer player(player_files(options), session.display(), nullptr, always_kept());
    FramePreroll preroll(player, session, session.device().frame_rate_hz);
    const IntervalStore store(options, files, session, player, preroll, console);
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

    [[nodiscard]] const test_support::TemporaryFolder& folder() const { return files.folder; }
};

struct Looked {
    std::vector<std::pair<std::int64_t, policy::TerrainAhead>> alerts;
    std::int64_t undecided = 0;  ///< before the last second, afterwards
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

TEST(IntervalStore, ADesignThatIsEditedWhileTheRunStartsLeavesNothingUnderAWrongKey) {
    Flown flown;
    const std::string old_text = "name = \"a\"\n", new_text = "name = \"a\"\n[effects]\nfade_s = 0.5\n";
    flown.options.picture.design = flown.folder().write("a.toml", old_text);
    const Drawn by_old = draw_at(flown.options, 8, [&] { static_cast<void>(flown.folder().write("a.toml", new_text)); });
    EXPECT_FALSE(std::filesystem::exists(flown.kept));
    EXPECT_EQ(draw_at(flown.options, 8).undecided, by_old.undecided) << "the new design has not decided anything yet";
    ASSERT_TRUE(std::filesystem::exists(flown.kept)) << "control: nobody edits it now";
    std::filesystem::remove(flown.kept);
    static_cast<void>(draw_at(flown.options, 8, [&] {
        static_cast<void>(flown.folder().write("a.toml", old_text));
        static_cast<void>(flown.folder().write("a.toml", new_text));
    }));
    EXPECT_FALSE(std::filesystem::exists(flown.kept)) << "which of the two was read";
}

/// Alerts of all intervals are kept, so that nothing is decided to look ahead.
TEST(IntervalStore, ALookAheadTakesWhatAnEarlierRunDecided) {
    Flown flown;
    const auto look_ahead = [&] {
        std::ostringstream results, notes;
        Console console(results, notes, false, false);
        const std::optional<DisplayFiles> files = IntervalStore::files_before_start(flown.options);
        DisplaySession session(flown.options.picture, false);
        FlightPlayer player(player_files(flown.options), session.display(), nullptr, always_kept());
        FramePreroll preroll(player, session, session.device().frame_rate_hz);
        const IntervalStore store(flown.options, files, session, player, preroll, console);
        Looked looked;
        preroll.look_ahead(player.last(),
                           [&](base::Time begin, policy::TerrainAhead alert) { looked.alerts.emplace_back(begin.ns, alert); });
        looked.undecided = preroll.undecided_before(player.last() - base::Duration::seconds(1));
        return looked;
    };
    const Looked first = look_ahead(), again = look_ahead();
    EXPECT_EQ(first.alerts, again.alerts);
    EXPECT_GT(first.alerts.size(), 15u);
    EXPECT_EQ(first.undecided, 0) << "every interval was decided";
    EXPECT_GT(again.undecided, 0) << "none was";
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
