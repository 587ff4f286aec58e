// What a frame shows must not depend on how a run came to it.
#include "host_sim/replay/frame_approach.hpp"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "tests/support/flown_circle.hpp"

namespace tedavis::host_sim {
namespace {

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

/// A second of steps so short that terrain arrives while frames are drawn.
ReplayOptions options(double from_s, double step_s) {
    ReplayOptions o = files().options("unused");
    o.from_s = from_s;
    o.to_s = 2.0;
    o.step_s = step_s;
    o.picture.size = PictureSize{800, 600};
    return o;
}

struct Frame {
    std::uint64_t hash = 0;
    std::uint32_t pending = 0, triangles = 0;
    double tau_px = 0;
    bool operator==(const Frame& o) const {
        return hash == o.hash && pending == o.pending && triangles == o.triangles && tau_px == o.tau_px;
    }
};

/// Frames by their time, in the order of the run.
std::map<std::int64_t, Frame> run(const ReplayOptions& asked, bool approached) {
    DisplaySession session(asked.picture, false);
    FlightPlayer player({asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display());
    const FrameInstants times(asked, player.first(), player.last(), session.device().frame_rate_hz);
    FrameApproach approach(player, session.display(), times);
    std::map<std::int64_t, Frame> frames;
    for (std::uint64_t n = 0; n < times.count(); ++n) {
        if (approached) approach.approach(times.backwards() ? times.count() - 1 - n : n);
        const PlayedInstant instant = player.at(times.at(n));
        session.display().update(instant.aircraft, instant.phase, times.at(n));
        session.draw();
        const display::TerrainRecord& terrain = session.display().record().terrain;
        frames[times.at(n).ns] = {session.frame_hash(), terrain.pending, terrain.triangles, terrain.tau_reached_px};
    }
    return frames;
}

std::size_t differences(const std::map<std::int64_t, Frame>& whole, const std::map<std::int64_t, Frame>& part) {
    std::size_t different = 0;
    for (const auto& [time, frame] : part) {
        EXPECT_EQ(whole.count(time), 1u) << time;
        different += whole.count(time) == 0 || !(whole.at(time) == frame) ? 1 : 0;
    }
    return different;
}

TEST(FrameApproach, APartOfARunHasTheFramesOfTheWhole) {
    const auto whole = run(options(0, 0.1), true);
    ASSERT_EQ(whole.size(), 21u);
    for (const double from_s : {0.1, 0.3, 0.9, 1.6}) {
        EXPECT_EQ(differences(whole, run(options(from_s, 0.1), true)), 0u) << "from " << from_s;
        EXPECT_GT(differences(whole, run(options(from_s, 0.1), false)), 0u)
            << "control: without what came before, from " << from_s;
    }
}

TEST(FrameApproach, BackwardsHasTheFramesOfForwards) {
    const auto whole = run(options(0, 0.1), true);
    EXPECT_EQ(differences(whole, run(options(0, -0.1), true)), 0u);
    EXPECT_EQ(differences(whole, run(options(1.2, -0.1), true)), 0u);
    EXPECT_GT(differences(whole, run(options(0, -0.1), false)), 0u) << "control";
}

TEST(FrameApproach, TheFirstFrameOfARunIsComplete) {
    const auto whole = run(options(0, 0.1), true);
    EXPECT_EQ(whole.begin()->second.pending, 0u);
    EXPECT_GT(run(options(0, 0.1), false).begin()->second.pending, 0u) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim
