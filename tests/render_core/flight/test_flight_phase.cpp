#include "render_core/flight/flight_phase.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace tedavis::flight::test_flight_phase {
namespace {

/// The list of the design document, written out once more: string -> code of message 1830.
const std::map<std::string, int>& documented_codes() {
    static const std::map<std::string, int> codes = {{"ground", 10},
                                                     {"takeoff", 20},
                                                     {"takeoff.start", 21},
                                                     {"takeoff.first_climb", 22},
                                                     {"takeoff.second_climb", 23},
                                                     {"cruise", 30},
                                                     {"approach", 40},
                                                     {"approach.descent", 41},
                                                     {"approach.initial", 42},
                                                     {"approach.final", 43},
                                                     {"approach.landing", 44},
                                                     {"go_around", 50},
                                                     {"go_around.abort", 51},
                                                     {"go_around.replanning", 52},
                                                     {"unknown", 60}};
    return codes;
}

std::string name_of(FlightPhase phase) {
    const std::string sub_phase = sub_phase_name(phase);
    return scenario_name(phase) + (sub_phase.empty() ? "" : "." + sub_phase);
}

TEST(FlightPhase, strings_and_codes_are_the_documented_list) {
    for (const auto& [name, code] : documented_codes()) {
        const ParsedPhase parsed = phase_from_name(name);
        ASSERT_TRUE(parsed.ok) << name;
        EXPECT_EQ(parsed.phase.code(), code) << name;
        EXPECT_EQ(name_of(parsed.phase), name);
        const ParsedPhase back = phase_from_code(static_cast<std::uint8_t>(code));
        ASSERT_TRUE(back.ok) << code;
        EXPECT_EQ(back.phase, parsed.phase);
    }
}

TEST(FlightPhase, no_other_code_is_accepted) {
    int accepted = 0;
    for (int code = 0; code < 256; ++code) {
        const ParsedPhase parsed = phase_from_code(static_cast<std::uint8_t>(code));
        if (!parsed.ok) continue;
        ++accepted;
        EXPECT_EQ(parsed.phase.code(), code);
    }
    EXPECT_EQ(accepted, static_cast<int>(documented_codes().size()));
}

TEST(FlightPhase, misspelt_names_are_refused) {
    for (const char* name : {"", ".", "takeoff.", ".start", "takeoff.landing", "TAKEOFF", "takeoff.start.x", "cruise.start",
                             "climb", "takeoff start"})
        EXPECT_FALSE(phase_from_name(name).ok) << name;
}

TEST(FlightPhase, names_of_impossible_phases_do_not_read_outside_the_table) {
    EXPECT_STREQ(sub_phase_name({Scenario::cruise, 3}), "");
    EXPECT_STREQ(sub_phase_name({Scenario::takeoff, 200}), "");
    EXPECT_STREQ(scenario_name({static_cast<Scenario>(77), 0}), "unknown");
}

TEST(FlightPhase, the_aspect_in_detail_follows_the_phase) {
    for (const auto& [name, code] : documented_codes()) {
        const Aspect expected = name == "cruise"                 ? Aspect::data
                                : name == "go_around.replanning" ? Aspect::uncertainty
                                                                 : Aspect::terrain;
        EXPECT_EQ(prioritized_aspect(phase_from_code(static_cast<std::uint8_t>(code)).phase), expected) << name;
    }
}

TEST(PhaseSource, names_are_the_recorded_ones) {
    EXPECT_STREQ(to_string(PhaseSource::switches), "switch");
    EXPECT_STREQ(to_string(PhaseSource::can), "can");
    EXPECT_STREQ(to_string(PhaseSource::motion), "motion");
    EXPECT_STREQ(to_string(PhaseSource::held), "held");
    EXPECT_STREQ(to_string(PhaseSource::none), "none");
    EXPECT_STREQ(to_string(static_cast<PhaseSource>(99)), "none");
}

}  // namespace
}  // namespace tedavis::flight::test_flight_phase
