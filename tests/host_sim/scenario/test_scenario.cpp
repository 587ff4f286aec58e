#include "host_sim/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scenario {
namespace {

std::string shipped() { return read_file(test_support::source_dir() + "/configs/scenarios/default.toml"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Scenario, ReadsTheShippedOne) {
    const Scenario scenario = parse_scenario(shipped(), "default.toml");
    EXPECT_EQ(scenario.name, "default");
    EXPECT_EQ(scenario.seed, 1u);
    EXPECT_EQ(scenario.start.ns, 1780322400 * std::int64_t{1'000'000'000});
    EXPECT_NEAR(base::degrees(scenario.strip.heading_rad), 240, 1e-12);
    EXPECT_NEAR(scenario.environment.qnh_pa, 101900, 1e-9);
    EXPECT_EQ(scenario.legs.front().kind, LegKind::stand);
    EXPECT_EQ(scenario.legs[1].kind, LegKind::roll);
    EXPECT_EQ(scenario.legs[1].stated_by, PhaseStatedBy::can);
    EXPECT_EQ(scenario.legs[1].phase, flight::kTakeoffStart);
    EXPECT_EQ(scenario.scene, test_support::source_dir() + "/configs/scenes/jacksboro.toml");
    ASSERT_TRUE(scenario.weather.has_value());
    EXPECT_EQ(scenario.weather->storm.cells, 9);
    EXPECT_EQ(scenario.traffic.size(), 4u);
    ASSERT_TRUE(scenario.radio_altimeter.has_value());
    EXPECT_EQ(scenario.radio_altimeter->terrain, test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif");
}

TEST(Scenario, SaysAllFaultsAtOnceAndNoneTwice) {
    const std::string faulty =
        "seed = -1\n"
        "[strip]\n"
        "latitude_deg = 47\n"
        "heading_deg = 999\n"
        "elevation_msl_m = 580\n"
        "[guidance]\n"
        "decision_height_m = 60\n"
        "flaps_travel_s = 20\n"
        "[[leg]]\n"
        "kind = \"stnad\"\n"
        "phase = \"ground\"\n"
        "duration_s = 5\n"
        "[[leg]]\n"
        "kind = \"roll\"\n"
        "phase = \"takeof\"\n"
        "speed_mps = 5\n"
        "acceleration_mps2 = 2\n";
    try {
        static_cast<void>(parse_scenario(faulty, "s.toml"));
        FAIL() << "it was accepted";
    } catch (const UserError& error) {
        std::istringstream lines(error.what());
        std::vector<std::string> places;
        for (std::string line; std::getline(lines, line);) places.push_back(line.substr(0, line.find(": ")));
        // Line 2: longitude_deg is missing; 6: minimum_msl_m is. What an unknown kind of leg has is nobody's fault.
        const std::vector<std::string> expected{"s.toml:1",  "s.toml:4",  "s.toml:2", "s.toml:6",
                                                "s.toml:10", "s.toml:16", "s.toml:15"};
        std::multiset<std::string> found(places.begin(), places.end()), wanted(expected.begin(), expected.end());
        EXPECT_EQ(found, wanted) << error.what();
    }
}

TEST(Scenario, AnEmptyPhaseAndTheLowestMinimumAreFaults) {
    const std::string text = shipped();
    const auto parsed = [](const std::string& changed) {
        return [changed] { static_cast<void>(parse_scenario(changed, "s.toml")); };
    };
    test_support::expect_user_error(parsed(replaced(text, "phase = \"ground\"", "phase = \"\"")), "no such flight phase");
    const std::size_t at = text.find("minimum_msl_m = ");
    const std::string minimum = text.substr(at, text.find('\n', at) - at);
    test_support::expect_user_error(parsed(replaced(text, minimum, "minimum_msl_m = -500")), "below the strip");
}

TEST(Scenario, NeedsNeitherSceneNorWeather) {
    std::string text = replaced(shipped(), "scene = \"jacksboro\"", "");
    const std::size_t from = text.find("[weather]");
    text.erase(from, text.find("[aircraft]") - from);
    const Scenario scenario = parse_scenario(text, "s.toml");
    EXPECT_TRUE(scenario.scene.empty());
    EXPECT_FALSE(scenario.weather.has_value());
}

/// Take-off, a climb and the landing: what no default can say.
TEST(Scenario, NeedsNoMoreThanAPlaceAndLegs) {
    const std::string smallest = R"(
[strip]
latitude_deg = 47
longitude_deg = 11
heading_deg = 260
elevation_msl_m = 580
[[leg]]
kind = "roll"
phase = "takeoff.start"
speed_mps = 48
acceleration_mps2 = 3
[[leg]]
kind = "hold"
phase = "takeoff.first_climb"
heading_deg = 260
altitude_msl_m = 900
speed_mps = 60
climb_mps = 8
)";
    const Scenario scenario = parse_scenario(smallest, "folder/evening.toml");
    EXPECT_EQ(scenario.name, "evening");
    EXPECT_EQ(scenario.seed, 1u);
    EXPECT_EQ(scenario.switch_config, "one_hot");
    EXPECT_EQ(scenario.start.ns, 1780315200 * std::int64_t{1'000'000'000});
    EXPECT_EQ(scenario.strip.length_m, 1000);
    EXPECT_EQ(scenario.environment.qnh_pa, 101325) << "the standard atmosphere";
    EXPECT_EQ(scenario.environment.wind_speed_mps, 0);
    EXPECT_EQ(scenario.aircraft.antenna_height_m, 2.5);
    EXPECT_EQ(scenario.legs.size(), 2u);
    test_support::expect_user_error([&] { (void)parse_scenario(smallest.substr(smallest.find("[[leg]]")), "s.toml"); },
                                    "there is no table [strip]");
    test_support::expect_user_error(
        [&] { (void)parse_scenario(replaced(smallest, "heading_deg = 260\nelevation", "elevation"), "s.toml"); },
        "'heading_deg' is missing");
}

TEST(Scenario, FindsASceneFileFromItsOwnFolder) {
    const test_support::TemporaryFolder place;
    place.write("own.toml", "");
    const std::string text = replaced(shipped(), "scene = \"jacksboro\"", "scene = \"own.toml\"");
    EXPECT_EQ(parse_scenario(text, place.file("s.toml")).scene, place.file("own.toml"));
    test_support::expect_user_error([&] { (void)parse_scenario(text, place.file("else/s.toml")); },
                                    "there is no scene file " + place.file("else/own.toml"));
}

TEST(Scenario, NamesFileAndLineOfAFault) {
    const auto refused = [](const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { (void)parse_scenario(text, "s.toml"); }, words);
    };
    refused("name = ", "s.toml:1");
    refused(replaced(shipped(), "heading_deg = 240", "heading_deg = 540"), "heading_deg");
    refused(replaced(shipped(), "heading_deg = 240", "heading_deg = nan"), "heading_deg");
    refused(replaced(shipped(), "kind = \"roll\"", "kind = \"rolling\""), "'kind' must be one of");
    refused(replaced(shipped(), "phase = \"cruise\"", "phase = \"lunch\""), "no such flight phase");
    refused(replaced(shipped(), "turbulence = 0.5", "turbulences = 0.5"), "turbulence");
    refused(replaced(shipped(), "2026-06-01T14:00:00Z", "yesterday"), "no time such as");
    refused(replaced(shipped(), "duration_s = 3", "duration_s = 3\nspeed_mps = 20"), "speed_mps");
    refused(shipped().substr(0, shipped().find("\n[[leg]]")), "[[leg]]");
    refused(replaced(shipped(), "scene = \"jacksboro\"", "scene = \"nowhere\""),
            "configs/scenes/nowhere.toml; name a shipped one");
    refused(replaced(shipped(), "terrain = \"jacksboro_srtm3\"", "terrain = \"nowhere\""), "there is no raster");
    refused(replaced(shipped(), "storm_cells = 9", "storm_cells = -9"), "storm_cells");
    refused(replaced(shipped(), "reach_m = 18000", "reach_m = 18000\nrech_m = 1"), "rech_m");
    const std::string text = replaced(shipped(), "storm_cells = 9", "storm_cells = -9");
    const auto line = std::to_string(1 + std::count(text.begin(), text.begin() + text.find("storm_cells"), '\n'));
    refused(text, "s.toml:" + line + ": ");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario
