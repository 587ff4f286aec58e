// A flight that comes over the terrain database: its first frame there has its terrain, however it is reached.
#include <gtest/gtest.h>

#include <map>

#include "host_sim/replay/frame_instants.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_entered_terrain {
namespace {

constexpr double kStep_s = 1.0 / 30;  ///< of the device
constexpr double kLasts_s = 3;

/// Eastwards over the western edge, at 9.6 E, two seconds after the log's begin.
class FlownInto final : public test_support::FlownCircle {
public:
    base::Time end() const override { return begin() + base::Duration::from_seconds(kLasts_s); }
    std::optional<SignalSample> at(base::Time time) const override {
        using flight::Signal;
        auto sample = FlownCircle::at(time);
        const double s = (time - begin()).to_seconds();
        (*sample)[Signal::latitude] = base::radians(47.02);
        (*sample)[Signal::longitude] = base::radians(9.6) + 60 * (s - 2) / 4.34e6;
        (*sample)[Signal::true_track] = (*sample)[Signal::true_heading] = base::kPi / 2;
        (*sample)[Signal::roll] = 0;
        return sample;
    }
};

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles{FlownInto()};
    return kFiles;
}

struct Frame {
    std::uint64_t hash = 0;
    std::uint32_t triangles = 0, pending = 0;
    bool is_inside = false, is_off = false;
    bool operator==(const Frame& o) const { return hash == o.hash && triangles == o.triangles && pending == o.pending; }
};

struct Flown {
    ReplayOptions asked = files().options("unused");
    DisplaySession session;
    FlightPlayer player;
    FramePreroll preroll;

    Flown()
        : session(small(asked), false), player(player_files(asked), session.display()), preroll(player, session, 1 / kStep_s) {}

    [[nodiscard]] static PictureOptions small(const ReplayOptions& asked) {
        PictureOptions picture = asked.picture;
        picture.size = PictureSize{160, 120};
        return picture;
    }
    [[nodiscard]] bool is_inside(const flight::FrameInput& input) {
        const earth::Geodetic& at = input.state.own_ship.position;
        const terrain::Lattice& lattice = session.display().planner().terrain_database()->lattice();
        return input.state.own_ship.state == base::SignalState::valid && lattice.point(at.latitude_rad, at.longitude_rad).inside;
    }
    [[nodiscard]] Frame draw(base::Time time) {
        const flight::FrameInput input = player.at(time);
        session.display().plan({input.state, input.phase, time, input.trail, input.legend});
        session.draw();
        const display::FrameRecord& record = session.display().record();
        return {session.frame_hash(), record.terrain.triangles, record.terrain.pending, is_inside(input),
                !session.display().planned().decisions.show_terrain};
    }
    [[nodiscard]] std::map<std::int64_t, Frame> fly(double from_s, double to_s, double step_s, bool has_preroll = true) {
        asked.from_s = from_s;
        asked.to_s = to_s;
        asked.step_s = step_s;
        const FrameInstants times(asked, player.first(), player.last(), 1 / kStep_s);
        std::map<std::int64_t, Frame> frames;
        for (std::uint64_t n = 0; n < times.count(); ++n) {
            EXPECT_TRUE(!has_preroll || preroll.preroll(times.at(n)));
            frames[times.at(n).ns] = draw(times.at(n));
        }
        return frames;
    }
};

const std::map<std::int64_t, Frame>& whole() {
    static const std::map<std::int64_t, Frame> kWhole = Flown().fly(0, kLasts_s, kStep_s);
    return kWhole;
}

std::int64_t entered() {
    for (const auto& [time, frame] : whole())
        if (frame.is_inside) return time;
    ADD_FAILURE() << "it never comes over the terrain";
    return 0;
}

double entered_s() { return static_cast<double>(entered() - whole().begin()->first) / 1e9; }

std::size_t differences(const std::map<std::int64_t, Frame>& part) {
    std::size_t different = 0;
    for (const auto& [time, frame] : part) different += whole().count(time) == 0 || !(whole().at(time) == frame) ? 1 : 0;
    return different;
}

std::size_t frames_without_terrain(const std::map<std::int64_t, Frame>& frames) {
    std::size_t without = 0;
    for (const auto& [time, frame] : frames)
        without += frame.is_inside && (frame.is_off || frame.triangles == 0 || frame.pending > 0) ? 1 : 0;
    return without;
}

TEST(EnteredTerrain, EveryFrameOverItHasAllOfIt) {
    ASSERT_GT(entered_s(), 1);
    ASSERT_LT(entered_s(), kLasts_s - 0.5);
    EXPECT_EQ(frames_without_terrain(whole()), 0u);
    EXPECT_EQ(frames_without_terrain(Flown().fly(0, kLasts_s, kStep_s, false)), 0u) << "as on a board, which has no preroll";
    const double at_s = entered_s();
    EXPECT_GT(frames_without_terrain(Flown().fly(at_s, kLasts_s, kStep_s, false)), 0u) << "control: nothing was read before";
}

TEST(EnteredTerrain, TheFirstFrameIsDrawnAsByADisplayThatHasStoodThere) {
    const base::Time time{entered()};  // another display, which must be gone before this one draws
    Flown stood;
    display::settle(stood.session.display(), stood.player.at(time));
    EXPECT_EQ(stood.draw(time).triangles, whole().at(entered()).triangles);
}

TEST(EnteredTerrain, AFrameIsTheSameHoweverItIsReached) {
    const double at_s = entered_s();
    for (const int frames : {-2, -1, 0, 1, 2, 7, 9})
        EXPECT_EQ(differences(Flown().fly(at_s + frames * kStep_s, kLasts_s, kStep_s)), 0u) << "from frame " << frames;
    for (const double frames : {2.0, -1.0, -7.0})
        EXPECT_EQ(differences(Flown().fly(0, kLasts_s, frames * kStep_s)), 0u) << "every " << frames << "th";
}

}  // namespace
}  // namespace tedavis::host_sim::test_entered_terrain
