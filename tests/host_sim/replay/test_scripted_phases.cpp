// A flight through all phases, as a bus and a panel of switches state them, with all that goes wrong on the way.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_scripted_phases {
namespace {

using flight::FlightPhase;
using flight::PhaseSource;
using flight::Scenario;

constexpr FlightPhase kCruise{Scenario::cruise, 0};

/// What the bus states from when on, in seconds.
struct Stated {
    double from_s;
    FlightPhase phase;
};
constexpr Stated kBus[] = {{0, flight::kTakeoffFirstClimb},   {10, kCruise},
                           {20, flight::kApproachDescent},    {28, flight::kGoAroundAbort},
                           {34, flight::kGoAroundReplanning}, {42, flight::kApproachDescent}};
constexpr double kLost_s = 62, kFound_s = 67;

class ScriptedFlight final : public test_support::FlownCircle {
public:
    base::Time end() const override { return begin() + base::Duration::seconds(70); }
    std::optional<SignalSample> at(base::Time time) const override {
        const double s = (time - begin()).to_seconds();
        std::optional<SignalSample> sample = FlownCircle::at(time);
        if (s < kLost_s || s >= kFound_s) return sample;
        SignalSample lost;  // attitude and air data alone
        using flight::Signal;
        for (const Signal kept : {Signal::pitch, Signal::roll, Signal::true_heading, Signal::indicated_airspeed,
                                  Signal::baro_altitude, Signal::baro_setting, Signal::vertical_speed})
            lost[kept] = (*sample)[kept];
        return lost;
    }
    std::optional<FlightPhase> stated_phase(base::Time time) const override {
        const double s = (time - begin()).to_seconds();
        FlightPhase phase;
        for (const Stated& stated : kBus)
            if (s >= stated.from_s) phase = stated.phase;
        return phase;
    }
};

std::string edge(double s, const char* line, int level) {
    char text[64];
    std::snprintf(text, sizeof text, "(%.6f) panel.%s %d\n", static_cast<double>(test_support::FlownCircle::kBegin_s) + s, line,
                  level);
    return text;
}

/// On AUTO, but for 48 to 56 s, where the pilot turns to CRUISE: it bounces both ways, and the bus goes on to state an approach.
std::string switch_log() {
    std::string text = "# tedavis switch log 1\n";
    for (const char* line : {"GROUND", "TAKEOFF", "CRUISE", "APPROACH", "GO_AROUND", "REPLAN"}) text += edge(0, line, 0);
    text += edge(0, "AUTO", 1);
    const auto turn = [&text](double s, const char* from, const char* to) {
        text += edge(s, from, 0) + edge(s + 0.002, from, 1) + edge(s + 0.004, from, 0);
        for (int n = 0; n < 5; ++n) text += edge(s + 0.006 + 0.004 * n, to, (n + 1) % 2);
    };
    turn(48, "AUTO", "CRUISE");
    turn(56, "CRUISE", "AUTO");
    return text;
}

/// One place, so that the designs that put data first have data: without a scene they wait.
std::string write_scene(const test_support::TemporaryFolder& folder) {
    LayerDraft layer;
    layer.name = "places";
    layer.role = scene::LayerRole::place;
    layer.points = {test_support::scene_point(47.06, 9.66, std::numeric_limits<float>::quiet_NaN())};
    layer.names = {"Ort"};
    const std::vector<std::uint8_t> bytes = sdb_bytes({"one place", "a test", 1, {layer}});
    return folder.write("place.sdb", std::string(bytes.begin(), bytes.end()));
}

struct Shown {
    double s = 0;
    display::FrameRecord record;
};

/// A frame each fifth of a second.
const std::vector<Shown>& flown() {
    static const std::vector<Shown> kShown = [] {
        static const test_support::FlownFiles kFiles{ScriptedFlight()};
        ReplayOptions o = kFiles.options("unused");
        o.picture.size = PictureSize{160, 120};
        o.picture.scene = write_scene(kFiles.folder);
        o.switches = kFiles.folder.write("flight.switches", switch_log());
        DisplaySession session(o.picture, false);
        FlightPlayer player({o.log, o.picture.bus, o.switches, o.switch_config}, session.display());
        FramePreroll preroll(player, session, session.device().frame_rate_hz);
        std::vector<Shown> shown;
        for (double s = 0; s < 70; s += 0.2) {
            const base::Time time = player.first() + base::Duration::from_seconds(s);
            EXPECT_TRUE(preroll.preroll(time));
            const flight::FrameInput instant = player.at(time);
            session.display().plan({instant.state, instant.phase, time, instant.trail});
            session.draw();
            shown.push_back({s, session.display().record()});
        }
        return shown;
    }();
    return kShown;
}

const display::FrameRecord& at(double s) {
    for (const Shown& shown : flown())
        if (shown.s >= s - 1e-6) return shown.record;
    return flown().back().record;
}

struct Expected {
    double s;
    FlightPhase phase;
    PhaseSource source;
    const char* design;
};

/// Phase and presentation of Table 5.1 at each moment: terrain, data, terrain, terrain, uncertainty, terrain, data, terrain
/// first.
TEST(ScriptedPhases, ThePictureFollowsBusAndSwitches) {
    const Expected kExpected[] = {
        {8, flight::kTakeoffFirstClimb, PhaseSource::can, "takeoff"},
        {18, kCruise, PhaseSource::can, "cruise"},
        {26, flight::kApproachDescent, PhaseSource::can, "approach"},
        {32, flight::kGoAroundAbort, PhaseSource::can, "approach"},
        {40, flight::kGoAroundReplanning, PhaseSource::can, "replanning"},
        {46, flight::kApproachDescent, PhaseSource::can, "approach"},
        {50, kCruise, PhaseSource::switches, "cruise"},
        {60, flight::kApproachDescent, PhaseSource::can, "approach"},
    };
    for (const Expected& expected : kExpected) {
        const display::FrameRecord& record = at(expected.s);
        EXPECT_EQ(record.phase.phase, expected.phase) << expected.s;
        EXPECT_EQ(record.phase.source, expected.source) << expected.s;
        EXPECT_EQ(record.design.view(), expected.design) << expected.s;
        EXPECT_EQ(record.earlier_share, 0) << expected.s << ": no turn is left";
        EXPECT_FALSE(record.phase.switch_fault) << expected.s;
    }
}

/// Weights and techniques of the three priorities, where nothing lies on the way.
TEST(ScriptedPhases, OneAspectIsFirstInEachPhase) {
    const auto stated = [](double s, std::size_t aspect) { return at(s).weights[aspect].stated; };
    for (const double s : {8.0, 26.0, 32.0, 46.0, 60.0}) {
        EXPECT_EQ(stated(s, 0), 1) << s;
        EXPECT_LT(stated(s, 1), 0.5) << s;
        EXPECT_LT(stated(s, 2), 0.5) << s;
        EXPECT_EQ(at(s).terrain_aspect.detail, 1) << s << ": shaded";
    }
    for (const double s : {18.0, 50.0}) {
        EXPECT_EQ(stated(s, 1), 1) << s;
        EXPECT_LT(stated(s, 0), 0.5) << s;
    }
    EXPECT_EQ(stated(40, 2), 1);
    EXPECT_LT(stated(40, 0), 0.5);
}

/// The frame after the phase is in effect has its record, and the picture takes its time: from then on each frame has less of the
/// one before.
TEST(ScriptedPhases, TurnsAreRecordedAtOnceAndFade) {
    const auto& frames = flown();
    int turns = 0;
    for (std::size_t n = 1; n < frames.size(); ++n) {
        const display::FrameRecord &before = frames[n - 1].record, &record = frames[n].record;
        EXPECT_LE(record.earlier_share, 1) << frames[n].s;
        if (record.design.view() == before.design.view()) {
            EXPECT_TRUE(record.earlier_share <= before.earlier_share) << frames[n].s << ": nothing flashes";
            continue;
        }
        ++turns;
        EXPECT_TRUE(record.phase.phase == record.phase.presented) << frames[n].s;
    }
    EXPECT_EQ(turns, 7) << "to takeoff, cruise, approach, replanning, approach, cruise, approach; bounces turn nothing";
}

TEST(ScriptedPhases, DisagreementIsSaidWhileItLasts) {
    EXPECT_FALSE(at(47).phase.disagreement);
    EXPECT_TRUE(at(54).phase.disagreement) << "the bus states an approach";
    EXPECT_FALSE(at(60).phase.disagreement);
    for (const Shown& shown : flown())
        EXPECT_TRUE(shown.s < 48.5 || shown.s > 55.9 || shown.record.design.view() == "cruise") << shown.s;
}

TEST(ScriptedPhases, WithoutAPlaceThereIsNoTerrainInAnyPhase) {
    const display::FrameRecord &lost = at(66), &found = at(69.5);
    EXPECT_EQ(lost.terrain_aspect.technique.view(), "none");
    EXPECT_EQ(lost.phase.phase, flight::kApproachDescent) << "the phase is still stated";
    EXPECT_EQ(lost.signals[static_cast<std::size_t>(flight::Signal::pitch)], base::SignalState::valid);
    EXPECT_NE(found.terrain_aspect.technique.view(), "none");
    EXPECT_EQ(found.design.view(), "approach");
}

/// The same flight, of which nobody states the phase.
class SilentFlight final : public test_support::FlownCircle {
public:
    base::Time end() const override { return begin() + base::Duration::seconds(60); }
};

/// A minute after the beginning.
flight::PhaseStatus phase_of_silent_flight(const std::string& phase, const std::string& aircraft) {
    static const test_support::FlownFiles kFiles{SilentFlight()};
    ReplayOptions o = kFiles.options("unused");
    o.picture.size = PictureSize{160, 120};
    o.picture.aircraft = aircraft;
    o.phase = phase;
    DisplaySession session(o.picture, false);
    FlightPlayer player(player_files(o), session.display());
    return player.at(player.last()).phase;
}

TEST(ScriptedPhases, ThePhaseOfARunIsThatOfItsOption) {
    const flight::PhaseStatus by_motion = phase_of_silent_flight("", "");
    EXPECT_EQ(by_motion.source, PhaseSource::motion);
    EXPECT_EQ(by_motion.phase, flight::kTakeoffSecondClimb) << "it climbs at 4 m/s";
    const flight::PhaseStatus stated = phase_of_silent_flight("approach.final", "");
    EXPECT_EQ(stated.source, PhaseSource::switches);
    EXPECT_EQ(stated.phase, flight::kApproachFinal);
    EXPECT_EQ(phase_of_silent_flight(kNoPhase, "").source, PhaseSource::none);
}

TEST(ScriptedPhases, MotionIsJudgedByTheClassOfTheAircraft) {
    EXPECT_EQ(phase_of_silent_flight("", "glider").phase, kCruise);
    EXPECT_EQ(phase_of_silent_flight("", "light_piston").phase, flight::kTakeoffSecondClimb);
}

}  // namespace
}  // namespace tedavis::host_sim::test_scripted_phases
