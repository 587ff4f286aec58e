#include "host_sim/flight_test/read_expectation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/flight_test/read_samples.hpp"

namespace tedavis::host_sim::test_read_expectation {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Expectation read(const std::string& text, std::vector<std::string>& faults) {
    return test_support::read_sample(text, faults, [](ScriptTable& table, ScriptFaults& found) {
        return read_expectation(table, {{"default"}, {}}, found);
    });
}
Expectation read(const std::string& text) {
    std::vector<std::string> faults;
    Expectation expectation = read(text, faults);
    EXPECT_THAT(faults, IsEmpty());
    return expectation;
}
std::vector<std::string> faults_of(const std::string& text) {
    std::vector<std::string> faults;
    static_cast<void>(read(text, faults));
    return faults;
}

TEST(ReadExpectation, ReadsTheThreeTimes) {
    const Expectation at = read("at_s = 3\nphase = \"cruise\"\n"), during = read("from_s = 3\nto_s = 5\nphase = \"cruise\"\n"),
                      within = read("after_s = 3\nwithin_s = 2\nphase = \"cruise\"\n");
    EXPECT_EQ(at.kind, WindowKind::at);
    EXPECT_EQ(during.kind, WindowKind::during);
    EXPECT_EQ(within.kind, WindowKind::within);
    EXPECT_EQ(within.to_s, 5);
    EXPECT_EQ(at.name, "3 s: phase cruise");
    EXPECT_EQ(during.name, "3 s to 5 s: phase cruise");
    EXPECT_EQ(within.name, "within 2 s after 3 s: phase cruise");
    EXPECT_EQ(read("at_s = 1\nno_flags = [\"pitch.lost\"]\n").name, "1 s: no_flags pitch.lost");
    EXPECT_EQ(read("at_s = 1\nname = \"mine\"\nphase = \"cruise\"\n").name, "mine");
}

TEST(ReadExpectation, RefusesOtherTimes) {
    const std::string phase = "phase = \"cruise\"\n";
    EXPECT_THAT(faults_of(phase), ElementsAre(HasSubstr("has one time")));
    EXPECT_THAT(faults_of("at_s = 1\nfrom_s = 1\nto_s = 2\n" + phase), ElementsAre(HasSubstr("has one time")));
    EXPECT_THAT(faults_of("from_s = 1\n" + phase), ElementsAre(HasSubstr("belong together")));
    EXPECT_THAT(faults_of("from_s = 3\nto_s = 2\n" + phase), ElementsAre(HasSubstr("to_s lies before from_s")));
    EXPECT_THAT(faults_of("after_s = 3\n" + phase), ElementsAre(HasSubstr("needs within_s")));
    EXPECT_THAT(faults_of("at_s = -1\n" + phase), ElementsAre(HasSubstr("'at_s' must be 0 to")));
}

TEST(ReadExpectation, AFlagCannotBeThereAndNot) {
    EXPECT_THAT(faults_of("at_s = 1\nflags = [\"pitch.lost\"]\nno_flags = [\"pitch.lost\"]\n"),
                ElementsAre(HasSubstr("no_flags pitch.lost contradicts flags pitch.lost")));
}

TEST(ReadExpectation, OneExpectationCannotContradictItself) {
    EXPECT_THAT(faults_of("at_s = 1\nflags = [\"pitch.lost\"]\nsignals = { pitch = \"valid\" }\n"),
                ElementsAre(HasSubstr("signals pitch valid contradicts flags pitch.lost")));
    EXPECT_THAT(faults_of("at_s = 1\ntext = [{ says = \"A\" }, { says = \"A\", there = false }]\n"),
                ElementsAre(HasSubstr("text no \"A\" contradicts text \"A\"")));
}

/// Of a pair of one expectation, and of the same pair in two.
void expect_excluded(const std::string& a, const std::string& b) {
    EXPECT_EQ(faults_of("at_s = 1\n" + a + b).size(), 1u) << a << b;
    EXPECT_EQ(faults_of("at_s = 1\n" + b + a).size(), 1u) << b << a;
}

TEST(ReadExpectation, ASignalThatIsNotThereHasNoValue) {
    const std::string value = "values = { true_heading_deg = [239, 241] }\n";
    for (const char* const state : {"lost", "missing", "invalid"}) {
        expect_excluded(value, "signals = { true_heading = \"" + std::string(state) + "\" }\n");
        expect_excluded(value, "flags = [\"true_heading." + std::string(state) + "\"]\n");
    }
    for (const char* const state : {"valid", "stale"})
        EXPECT_THAT(faults_of("at_s = 1\n" + value + "signals = { true_heading = \"" + state + "\" }\n"), IsEmpty()) << state;
    EXPECT_THAT(faults_of("at_s = 1\n" + value + "signals = { pitch = \"lost\" }\n"), IsEmpty()) << "another signal";
}

TEST(ReadExpectation, RangesOfOneSignalHaveACommonValue) {
    EXPECT_THAT(faults_of("at_s = 1\nvalues = { pitch_deg = [9, 11], pitch_rad = [0.3, 0.4] }\n"),
                ElementsAre(HasSubstr("values pitch_rad 0.3 to 0.4 contradicts values pitch_deg 9 to 11")));
    EXPECT_THAT(faults_of("at_s = 1\nvalues = { pitch_deg = [9, 18], pitch_rad = [0.3, 0.4] }\n"), IsEmpty()) << "17.2 to 18";
    EXPECT_THAT(faults_of("at_s = 1\nvalues = { roll_deg = [90, 91], roll_rad = [1, 1.5707963267948966] }\n"), IsEmpty())
        << "a bound that they share";
    EXPECT_THAT(faults_of("at_s = 1\nvalues = { roll_deg = [1, 2], pitch_deg = [3, 4] }\n"), IsEmpty()) << "two signals";
}

TEST(ReadExpectation, APhaseHasASourceThatCanStateIt) {
    expect_excluded("phase = \"cruise\"\n", "phase_source = \"none\"\n");
    expect_excluded("phase = \"unknown\"\n", "phase_source = \"switch\"\n");
    expect_excluded("phase = \"unknown\"\n", "phase_source = \"can\"\n");
    for (const char* const source : {"none", "motion", "held"})
        EXPECT_THAT(faults_of("at_s = 1\nphase = \"unknown\"\nphase_source = \"" + std::string(source) + "\"\n"), IsEmpty());
    for (const char* const source : {"switch", "can", "motion", "held"})
        EXPECT_THAT(faults_of("at_s = 1\nphase = \"cruise\"\nphase_source = \"" + std::string(source) + "\"\n"), IsEmpty());
}

TEST(ReadExpectation, OnlyWhatIsReachedCanStay) {
    EXPECT_TRUE(read("after_s = 3\nwithin_s = 2\nstays = true\nphase = \"cruise\"\n").stays);
    EXPECT_THAT(faults_of("at_s = 1\nstays = true\nphase = \"cruise\"\n"), ElementsAre(HasSubstr("'stays' belongs to")));
}

std::size_t contradictions(const std::string& a, const std::string& b) {
    ScriptFaults faults;
    find_contradictions({read(a), read(b)}, faults);
    return faults.count();
}

TEST(ReadExpectation, FindsContradictions) {
    const std::string cruise = "from_s = 2\nto_s = 5\nphase = \"cruise\"\n";
    EXPECT_EQ(contradictions(cruise, "at_s = 3\nphase = \"ground\"\n"), 1u);
    EXPECT_EQ(contradictions(cruise, "at_s = 6\nphase = \"ground\"\n"), 0u) << "another time";
    EXPECT_EQ(contradictions(cruise, "at_s = 3\nphase_source = \"can\"\n"), 0u) << "another key";
    EXPECT_EQ(contradictions(cruise, "after_s = 3\nwithin_s = 1\nphase = \"ground\"\n"), 1u)
        << "it can only be reached against the other one";
    EXPECT_EQ(contradictions(cruise, "after_s = 4\nwithin_s = 2\nphase = \"ground\"\n"), 0u) << "it may be reached later";
    EXPECT_EQ(contradictions("after_s = 1\nwithin_s = 2\nstays = true\nphase = \"ground\"\n", cruise), 1u) << "it stays to 3 s";
    EXPECT_EQ(contradictions("at_s = 1\nphase = \"approach\"\n", "at_s = 1\nphase = \"approach.final\"\n"), 0u) << "a part";
    EXPECT_EQ(contradictions("at_s = 1\nflags = [\"utc.lost\"]\n", "at_s = 1\nno_flags = [\"utc.lost\"]\n"), 1u);
    const std::pair<const char*, const char*> kOpposites[] = {
        {"signals = { pitch = \"valid\" }\n", "signals = { pitch = \"lost\" }\n"},
        {"effects = { haze = \"run\" }\n", "effects = { haze = \"skipped\" }\n"},
        {"elements = { heading = \"normal\" }\n", "elements = { heading = \"failed\" }\n"},
        {"text = { says = \"A\" }\n", "text = { says = \"A\", there = false }\n"},
        {"signals = { pitch = \"valid\" }\n", "flags = [\"pitch.lost\"]\n"},
        {"flags = [\"pitch.stale\"]\n", "flags = [\"pitch.lost\"]\n"},
        {"values = { pitch_deg = [1, 2] }\n", "values = { pitch_deg = [3, 4] }\n"},
        {"values = { pitch_deg = [1, 2] }\n", "signals = { pitch = \"lost\" }\n"},
        {"phase = \"cruise\"\n", "phase_source = \"none\"\n"},
    };
    for (const auto& [a, b] : kOpposites) {
        const std::string at = "at_s = 1\n";
        EXPECT_EQ(contradictions(at + a, at + b), 1u) << a << b;
        EXPECT_EQ(contradictions(at + a, at + a), 0u) << a;
    }
    EXPECT_EQ(contradictions("at_s = 1\nsignals = { vertical_speed = \"valid\" }\n",
                             "at_s = 1\nelements = { vertical_speed = \"normal\" }\n"),
              0u)
        << "the signal, and what is shown of it";
    EXPECT_EQ(contradictions("at_s = 1\nsignals = { pitch = \"valid\" }\n", "at_s = 1\nflags = [\"roll.lost\"]\n"), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_read_expectation
