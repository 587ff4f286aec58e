#include "host_sim/flight_test/read_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/calendar_time.hpp"
#include "render_core/base/units.hpp"
#include "tests/host_sim/flight_test/read_samples.hpp"

namespace tedavis::host_sim::test_read_steps {
namespace {

using flight::Signal;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

bus::SwitchConfig one_hot() {
    const std::string path = resolve_config("one_hot", "switches");
    return bus::load_switch_config(read_file(path), path).value();
}

TestStep read(const std::string& text, std::vector<std::string>& faults) {
    return test_support::read_sample(text, faults, [](ScriptTable& table, ScriptFaults& found) {
        return read_step(table, bus::BusSettings(), one_hot(), found);
    });
}
TestStep read(const std::string& text) {
    std::vector<std::string> faults;
    TestStep step = read(text, faults);
    EXPECT_THAT(faults, IsEmpty());
    return step;
}

TEST(ReadSteps, ReadsSignals) {
    const TestStep step = read(
        "at_s = 5\nhold = { indicated_airspeed_kt = 90 }\nramp = { pitch_deg = 10 }\nover_s = 4\n"
        "stop = [\"position\", \"phase\"]\nsend = [\"roll\", \"clock\"]\ninvalid = [\"true_heading\"]\n");
    EXPECT_EQ(step.at_s, 5);
    EXPECT_EQ(step.line, 1u);
    EXPECT_NEAR(step.hold[0].si, 46.3, 1e-9);
    EXPECT_NEAR(step.ramp[0].si, base::radians(10), 1e-12);
    EXPECT_EQ(step.over_s, 4);
    EXPECT_EQ(step.stop.size(), 3u);
    EXPECT_TRUE(step.stops_phase);
    EXPECT_TRUE(step.sends_clock);
    EXPECT_FALSE(step.stops_clock);
    EXPECT_THAT(step.invalid, ElementsAre(Signal::true_heading));
}

TEST(ReadSteps, ReadsPhasesAndFrames) {
    const TestStep step =
        read("at_s = 1\nphase = \"approach.final\"\nphase_valid = false\nphase_origin = \"pilot\"\nframe = \"125#0102\"\n");
    EXPECT_EQ(*step.phase, flight::kApproachFinal);
    EXPECT_FALSE(step.phase_valid);
    EXPECT_EQ(step.phase_origin, bus::PhaseOrigin::pilot);
    EXPECT_EQ(step.frames[0].id, 0x125u);
    EXPECT_EQ(step.frames[0].length, 2);
}

TEST(ReadSteps, ALineAloneIsActive) {
    const TestStep step = read("at_s = 1\nswitch = \"CRUISE\"\n");
    ASSERT_EQ(step.lines.size(), 7u);
    for (const LineLevel& line : step.lines) EXPECT_EQ(line.level, line.line == 2) << line.line;
}

TEST(ReadSteps, APhaseStandsForItsPattern) {
    const TestStep step = read("at_s = 1\nswitch = \"go_around.replanning\"\n");
    for (const LineLevel& line : step.lines) EXPECT_EQ(line.level, line.line == 5) << line.line;
}

TEST(ReadSteps, ReadsLinesAndBounce) {
    const TestStep step =
        read("at_s = 1\nlines = { GROUND = 0, AUTO = 1 }\nbounce = { line = \"AUTO\", times = 5, gap_ms = 3 }\n");
    EXPECT_EQ(step.lines[1].line, 6u);
    EXPECT_TRUE(step.lines[1].level);
    EXPECT_EQ(step.bounce->times, 5u);
    EXPECT_NEAR(step.bounce->gap_s, 0.003, 1e-12);
}

TEST(ReadSteps, AllThatIsWrongIsToldAtOnce) {
    std::vector<std::string> faults;
    static_cast<void>(
        read("hold = { airspeed = 3, pitch_deg = \"x\" }\nover_s = 3\nstop = [\"wings\"]\nphase = \"start\"\n"
             "switch = \"GEAR\"\nlines = { GROUND = 2 }\nbounce = { line = \"GROUND\" }\nframe = \"12#X\"\nhop = 1\n",
             faults));
    EXPECT_THAT(faults, ElementsAre(HasSubstr("no time; say at_s"), HasSubstr("1: 'airspeed' is no signal"),
                                    HasSubstr("'pitch_deg' must be a finite number"), HasSubstr("2: 'over_s' belongs to a ramp"),
                                    HasSubstr("3: 'stop': there is no 'wings'"), HasSubstr("4: 'phase': there is no 'start'"),
                                    HasSubstr("5: 'switch': the panel has no line and no pattern 'GEAR'"),
                                    HasSubstr("6: 'GROUND' must be 0 or 1"), HasSubstr("7: 'bounce' says a line"),
                                    HasSubstr("8: 'frame': '12#X' is no frame"), HasSubstr("9: unknown key 'hop'")));
}

TEST(ReadSteps, ContradictionsAndImpossibleValuesAreFaults) {
    const std::pair<const char*, const char*> kPairs[] = {
        {"hold = { pitch_deg = 1, pitch_rad = 1 }", "'pitch_rad' says what another key"},
        {"hold = { pitch_deg = 1 }\nramp = { pitch_deg = 2 }\nover_s = 1", "'pitch' is in hold and in ramp"},
        {"stop = [\"position\"]\nsend = [\"latitude\"]", "'latitude' is in stop and in send"},
        {"stop = [\"all\"]\ninvalid = [\"attitude\"]", "'pitch' is in stop and in invalid"},
        {"hold = { pitch_deg = 1 }\nstop = [\"attitude\"]", "'pitch' is in hold and in stop"},
        {"stop = [\"clock\"]\nsend = [\"clock\"]", "'clock' is in stop and in send"},
        {"stop = [\"phase\"]\nphase = \"cruise\"", "'phase' is stated and stopped"},
        {"bounce = { line = \"CRUISE\", times = 2.7, gap_ms = 3 }", "'times' must be a whole number"},
        {"hold = { pitch_deg = 500 }", "'pitch_deg' must be -90 to 90"},
        {"hold = { latitude_deg = 120 }", "'latitude_deg' must be -90 to 90"},
        {"hold = { outside_temperature_c = -400 }", "'outside_temperature_c' must be -123.15 to"},
        {"hold = { indicated_airspeed_kt = 1e300 }", "'indicated_airspeed_kt' must be"},
    };
    for (const auto& [text, sentence] : kPairs) {
        std::vector<std::string> faults;
        static_cast<void>(read(std::string("at_s = 1\n") + text, faults));
        EXPECT_THAT(faults, ElementsAre(HasSubstr(sentence))) << text;
    }
    EXPECT_EQ(read("at_s = 1\nhold = { true_track_deg = 360, pitch_deg = -90 }\n").hold.size(), 2u) << "the ends belong to it";
}

TEST(ReadSteps, SignalsThatTheBusStatesItselfAreRefused) {
    const std::string bus_text = "[[message]]\nsignal = \"radio_height\"\nidentifier = 1860\nunit = \"ft\"\n";
    const bus::BusSettings bus = bus::load_bus_settings(bus_text, "b.toml").value();
    std::vector<std::string> faults;
    static_cast<void>(test_support::read_sample(
        "at_s = 1\nhold = { radio_height_m = 3 }\n", faults,
        [&](ScriptTable& table, ScriptFaults& found) { return read_step(table, bus, one_hot(), found); }));
    EXPECT_THAT(faults, ElementsAre(HasSubstr("[[message]] of its own for 'radio_height_m'")));
}

/// That it could not be read has been told.
TEST(ReadSteps, NamesOfAPanelThatCouldNotBeReadAreNotLookedAt) {
    std::vector<std::string> faults;
    static_cast<void>(test_support::read_sample(
        "at_s = 1\nswitch = \"CRUISE\"\nlines = { GROUND = 0 }\nbounce = { line = \"CRUISE\", times = 5, gap_ms = 3 }\n", faults,
        [](ScriptTable& table, ScriptFaults& found) {
            return read_step(table, bus::BusSettings(), bus::SwitchConfig(), found);
        }));
    EXPECT_THAT(faults, IsEmpty());
}

TestStart start_of(const std::string& text, std::vector<std::string>& faults) {
    return test_support::read_sample(text, faults, [](ScriptTable& table, ScriptFaults&) { return read_start(table); });
}

TEST(ReadSteps, AStartHasDefaults) {
    std::vector<std::string> faults;
    const TestStart flying = start_of("", faults), standing = start_of("motion = \"standing\"\n", faults);
    EXPECT_THAT(faults, IsEmpty());
    EXPECT_GT(flying.speed_mps, 0);
    EXPECT_EQ(standing.speed_mps, 0);
    EXPECT_LT(standing.altitude_msl_m, flying.altitude_msl_m);
    EXPECT_FALSE(flying.ground_msl_m);
}

TEST(ReadSteps, AStartIsStatedInTheCockpitsUnits) {
    std::vector<std::string> faults;
    const TestStart start = start_of(
        "altitude_msl_ft = 1000\nspeed_kt = 90\nvertical_speed_fpm = -500\nheading_deg = 90\n"
        "ground_msl_m = 100\nutc = \"2026-07-01T10:00:00Z\"\n",
        faults);
    EXPECT_THAT(faults, IsEmpty());
    EXPECT_NEAR(start.altitude_msl_m, 304.8, 1e-9);
    EXPECT_NEAR(start.speed_mps, 46.3, 1e-9);
    EXPECT_NEAR(start.climb_mps, -2.54, 1e-9);
    EXPECT_NEAR(start.heading_rad, base::radians(90), 1e-12);
    EXPECT_EQ(start.ground_msl_m, 100);
    EXPECT_EQ(utc_text(start.time), "2026-07-01T10:00:00Z");
}

TEST(ReadSteps, AStartInTwoUnitsIsAFault) {
    std::vector<std::string> faults;
    static_cast<void>(start_of("speed_kt = 90\nspeed_mps = 45\n", faults));
    EXPECT_THAT(faults, ElementsAre(HasSubstr("says what another key says")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_read_steps
