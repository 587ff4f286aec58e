#include "host_sim/flight_test/read_conditions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/flight_test/read_samples.hpp"

namespace tedavis::host_sim::test_read_conditions {
namespace {

using base::SignalState;
using flight::Signal;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<FrameCondition> read(const std::string& text, std::vector<std::string>& faults) {
    return test_support::read_sample(text, faults, [](ScriptTable& table, ScriptFaults& found) {
        return read_conditions(table, {{"default", "cruise"}, {}}, found);
    });
}

std::vector<std::string> faults_of(const std::string& text) {
    std::vector<std::string> faults;
    static_cast<void>(read(text, faults));
    return faults;
}

/// Of the only condition of a text.
bool holds(const std::string& text, const ObservedFrame& frame) {
    std::vector<std::string> faults;
    const auto conditions = read(text, faults);
    EXPECT_THAT(faults, IsEmpty());
    EXPECT_EQ(conditions.size(), 1u);
    return conditions.size() == 1 && conditions[0].observe(frame).holds;
}

ObservedFrame sample_frame() {
    ObservedFrame frame;
    frame.record.phase = flight::stated_phase(flight::kApproachFinal, flight::PhaseSource::can);
    frame.record.design = "cruise";
    static_cast<void>(frame.record.flags.try_push_back("pitch.lost"));
    frame.record.signals[static_cast<std::size_t>(Signal::pitch)] = SignalState::lost;
    display::EffectRecord effect;
    effect.name = "haze";
    effect.state = display::EffectState::skipped;
    static_cast<void>(frame.record.effects.try_push_back(effect));
    frame.record.elements[static_cast<std::size_t>(policy::Element::heading)] = policy::ElementShow::substituted;
    frame.record.alerts.terrain = policy::TerrainAhead::caution;
    frame.latency_frames = 1.5;
    frame.record.alerts.is_watching = true;
    frame.has_obstacles = true;
    frame.values[Signal::indicated_airspeed] = 46.3;  // 90 kt
    frame.record.signals[static_cast<std::size_t>(Signal::indicated_airspeed)] = SignalState::valid;
    frame.words = {{"TERRAIN AHEAD", 10, 10, {"annunciations"}}};
    return frame;
}

/// Each holds in the sample, and its neighbour does not.
TEST(ReadConditions, EachReadsItsEntryOfTheRecord) {
    const ObservedFrame frame = sample_frame();
    const std::pair<const char*, const char*> kPairs[] = {
        {"phase = \"approach.final\"", "phase = \"approach.initial\""},
        {"phase = \"approach\"", "phase = \"cruise\""},
        {"phase_source = \"can\"", "phase_source = \"switch\""},
        {"design = \"cruise\"", "design = \"default\""},
        {"flags = [\"pitch.lost\"]", "flags = [\"roll.lost\"]"},
        {"no_flags = [\"roll.lost\"]", "no_flags = [\"pitch.lost\"]"},
        {"signals = { pitch = \"lost\" }", "signals = { pitch = \"valid\" }"},
        {"effects = { haze = \"skipped\" }", "effects = { haze = \"run\" }"},
        {"elements = { heading = \"substituted\" }", "elements = { heading = \"normal\" }"},
        {"alert = \"caution\"", "alert = \"warning\""},
        {"obstacle_alert = \"none\"", "obstacle_alert = \"caution\""},
        {"latency_frames_at_most = 2", "latency_frames_at_most = 1"},
        {"text = { says = \"TERRAIN AHEAD\", in = \"annunciations\" }", "text = { says = \"TERRAIN AHEAD\", in = \"heading\" }"},
        {"text = { says = \"PULL UP\", there = false }", "text = { says = \"TERRAIN\", there = false }"},
        {"text = { says = \"AHEAD\" }", "text = { says = \"HEAD\" }"},
        {"values = { indicated_airspeed_kt = [89.9, 90.1] }", "values = { indicated_airspeed_kt = [90.1, 91] }"},
    };
    for (const auto& [kept, broken] : kPairs) {
        EXPECT_TRUE(holds(kept, frame)) << kept;
        EXPECT_FALSE(holds(broken, frame)) << broken;
    }
}

/// A display that cannot alert has no alert, but that says nothing.
TEST(ReadConditions, NoAlertNeedsAWatch) {
    ObservedFrame frame = sample_frame();
    frame.record.alerts.terrain = policy::TerrainAhead::none;
    EXPECT_TRUE(holds("alert = \"none\"", frame));
    EXPECT_FALSE(holds("alert = \"not_watching\"", frame));
    frame.has_obstacles = false;
    EXPECT_FALSE(holds("obstacle_alert = \"none\"", frame)) << "no data of obstacles";
    EXPECT_TRUE(holds("obstacle_alert = \"not_watching\"", frame));
    frame.has_obstacles = true;
    frame.record.alerts.is_watching = false;
    EXPECT_FALSE(holds("alert = \"none\"", frame));
    EXPECT_TRUE(holds("alert = \"not_watching\"", frame));
    EXPECT_FALSE(holds("obstacle_alert = \"none\"", frame));
}

/// A scenario stands for its sub-phases, too; "none" for the scenario alone.
TEST(ReadConditions, APhaseCanHaveNoSubPhase) {
    ObservedFrame frame = sample_frame();
    EXPECT_FALSE(holds("phase = \"approach.none\"", frame));
    frame.record.phase.phase = flight::phase_from_name("approach").phase;
    EXPECT_TRUE(holds("phase = \"approach.none\"", frame));
    EXPECT_FALSE(holds("phase = \"takeoff.none\"", frame));
    EXPECT_EQ(exact_phase_text(frame.record.phase.phase), "approach.none");
    EXPECT_EQ(exact_phase_text(flight::phase_from_name("approach.final").phase), "approach.final");
    EXPECT_EQ(exact_phase_text(flight::phase_from_name("cruise").phase), "cruise");
}

TEST(ReadConditions, AnElementAndHowItIsShownHaveTheirNames) {
    EXPECT_THAT(faults_of("elements = { headin = \"failed\" }"), ElementsAre(HasSubstr("there is no 'headin'; say heading")));
    EXPECT_THAT(faults_of("elements = { heading = \"lost\" }"), ElementsAre(HasSubstr("substituted, flagged, failed or absent")));
    EXPECT_THAT(faults_of("elements = { heading = \"failed\", altitude = \"absent\", wind = \"flagged\" }"), IsEmpty());
}

TEST(ReadConditions, ARangeExists) {
    EXPECT_THAT(faults_of("values = { true_heading_deg = [361, 365] }"), ElementsAre(HasSubstr("must be -180 to 360")));
    EXPECT_THAT(faults_of("values = { true_heading_deg = [350, 10] }"),
                ElementsAre(AllOf(HasSubstr("the lowest and the highest value"), HasSubstr("does not pass north"))));
    EXPECT_THAT(faults_of("values = { pitch_deg = [5, 4] }"), ElementsAre(Not(HasSubstr("north"))));
    EXPECT_THAT(faults_of("values = { true_heading_deg = [350, 370] }"), IsEmpty());
}

/// What is expected is not what is found.
TEST(ReadConditions, AFlagThatMustNotBeThereSaysSo) {
    std::vector<std::string> faults;
    const auto conditions = read("no_flags = [\"pitch.lost\"]", faults);
    ASSERT_EQ(conditions.size(), 1u);
    EXPECT_EQ(conditions[0].expected, "no pitch.lost");
    EXPECT_THAT(conditions[0].observe(sample_frame()).found, HasSubstr("pitch.lost"));
}

TEST(ReadConditions, AValueThatIsLostIsNone) {
    ObservedFrame frame = sample_frame();
    frame.record.signals[static_cast<std::size_t>(Signal::indicated_airspeed)] = SignalState::lost;
    EXPECT_FALSE(holds("values = { indicated_airspeed_kt = [89, 91] }", frame));
}

/// Each of them would hold whatever the display shows.
TEST(ReadConditions, WhatAsksForNothingIsAFault) {
    const std::pair<const char*, const char*> kPairs[] = {
        {"text = { says = \"  \", there = false }", "'text' needs says"},
        {"text = { says = \"\u4e2d\", there = false }", "typeface has no"},
        {"text = { says = \"90\", in = \"airspeed\" }", "may be a mark of a scale"},
        {"text = { says = \"90\" }", "may be a mark of a scale"},
        {"text = []", "'text' is empty"},
        {"signals = {}", "'signals' is empty"},
        {"flags = []", "'flags' is empty"},
        {"values = { indicated_airspeed_kt = 90 }", "two numbers"},
        {"values = { indicated_airspeed_kt = [91, 89] }", "two numbers"},
    };
    for (const auto& [text, sentence] : kPairs) {
        std::vector<std::string> faults;
        static_cast<void>(read(text, faults));
        EXPECT_THAT(faults, ElementsAre(HasSubstr(sentence))) << text;
    }
}

TEST(ReadConditions, AScenarioIsNoSubPhase) {
    ObservedFrame frame = sample_frame();
    frame.record.phase.phase = {flight::Scenario::approach, 0};
    EXPECT_TRUE(holds("phase = \"approach\"", frame));
    EXPECT_FALSE(holds("phase = \"approach.final\"", frame));
}

TEST(ReadConditions, SaysWhatWasFoundAndWhy) {
    std::vector<std::string> faults;
    const Observation found = read("phase_source = \"switch\"", faults)[0].observe(sample_frame());
    EXPECT_EQ(found.found, "can");
    EXPECT_EQ(found.reason, "phase approach.final of source can");
}

TEST(ReadConditions, AllThatIsWrongIsToldAtOnce) {
    std::vector<std::string> faults;
    static_cast<void>(
        read("phase = \"aproach\"\nphase_source = \"swich\"\ndesign = \"cruse\"\nflags = [\"pitch.gone\"]\n"
             "signals = { pich = \"lost\", roll = \"gone\" }\neffects = { haz = \"run\" }\nalert = \"red\"\n"
             "text = { says = \"A\", in = \"top\" }\n",
             faults));
    EXPECT_THAT(faults, ElementsAre(HasSubstr("f.toml:1: 'phase': there is no 'aproach'; say approach"),
                                    HasSubstr("f.toml:2: 'phase_source': there is no 'swich'; say switch"),
                                    HasSubstr("f.toml:3: 'design': there is no 'cruse'; say cruise"),
                                    HasSubstr("f.toml:4: 'flags': there is no 'pitch.gone'"),
                                    HasSubstr("f.toml:5: 'signals': there is no 'pich'; say pitch"),
                                    HasSubstr("f.toml:5: 'roll' must be missing"), HasSubstr("f.toml:6: 'effects'"),
                                    HasSubstr("f.toml:7: 'alert'"), HasSubstr("f.toml:8: 'in'")));
}

TEST(ReadConditions, AnEmptyTableAsksForNothing) {
    std::vector<std::string> faults;
    static_cast<void>(read("", faults));
    EXPECT_THAT(faults, ElementsAre(HasSubstr("asks for nothing")));
}

TEST(ReadConditions, PhaseNamesAreThoseOfTheCodes) {
    EXPECT_EQ(phase_names().size(), 15u);
    for (const std::string& name : phase_names()) {
        const flight::ParsedPhase parsed = flight::phase_from_name(name);
        EXPECT_TRUE(parsed.ok) << name;
        EXPECT_EQ(phase_text(parsed.phase), name);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_read_conditions
