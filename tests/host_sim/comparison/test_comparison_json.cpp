#include "host_sim/comparison/comparison_json.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_comparison_json {
namespace {

TEST(ComparisonJson, HasBothValuesOfEachInstant) {
    ComparedRun a = made_run("a", 10), b = with_log(made_run("b", 10, 0.5), "a.log");
    for (std::size_t n = 0; n < 10; ++n) b.frames[n].values[kAltitude] = 2000 + 10 * static_cast<double>(n);
    b.frames[2].values[kLabelsPlaced] = 8;
    const auto json = comparison_json(compared_runs(a, b, {}));
    EXPECT_EQ(json.begin().key(), "comparison") << "files are told by their first key";
    ASSERT_EQ(json["instants"].size(), 9u);
    const auto& instant = json["instants"][1];
    EXPECT_EQ(instant["a"]["frame"], 2);
    EXPECT_EQ(instant["position_in_b"], 1.5);
    EXPECT_EQ(instant["a"]["altitude"], 1000);
    EXPECT_EQ(instant["b"]["altitude"], 2015) << "between two frames";
    EXPECT_EQ(instant["b"]["labels_placed"], 8) << "of the nearest frame";
    EXPECT_TRUE(instant["a"]["crowded_regions"].is_null());
    EXPECT_EQ(json["alignment"]["by"], "time");
    EXPECT_EQ(json["alignment"]["without_counterpart"], 1);
    EXPECT_EQ(json["equal"], false);
    EXPECT_EQ(json["differences"][0]["quantity"], "altitude");
    EXPECT_EQ(comparison_json(compared_runs(a, a, {}))["equal"], true);
}

TEST(ComparisonJson, SaysWhatIsNotKnownAndNotSearched) {
    ComparedRun a = made_run("a", 8000), b = made_run("b", 10);
    for (ComparedFrame& frame : b.frames) frame.hash = "0000000000000000";
    for (ComparedFrame& frame : b.frames) frame.values[kAltitude] = kUnknown;
    const RunComparison runs = compared_runs(a, b, {Alignment::place, 3000});
    const auto json = comparison_json(runs);
    EXPECT_EQ(json["alignment"]["stride_a"], 3);
    EXPECT_EQ(json["alignment"]["stride_b"], 1);
    EXPECT_EQ(json["alignment"]["searched"], 2667);
    EXPECT_EQ(json["alignment"]["without_counterpart"], 2667 - runs.aligned.instants.size());
    EXPECT_EQ(json["known_pictures"], 0);
    EXPECT_EQ(json["equal_pictures"], 0);
    EXPECT_EQ(json["known_by_one"]["altitude"], runs.aligned.instants.size());
    EXPECT_EQ(json["instants"][0]["a"]["hash"], "5f");
    EXPECT_TRUE(json["instants"][0]["b"]["hash"].is_null());
}

/// Twenty instants of the first run, for which the second one has five frames.
TEST(ComparisonJson, CountsAFrameOnceHoweverManyInstantsItServes) {
    const ComparedRun a = made_run("a", 20);
    ComparedRun b = with_log(made_run("b", 5, 0, 4.75), "a.log");
    for (std::size_t n = 0; n < 5; ++n)
        b.frames[n].effects = n < 2 ? std::vector<std::string>{"fog"} : std::vector<std::string>{};
    const auto json = comparison_json(compared_runs(a, b, {}));
    EXPECT_EQ(json["instants"].size(), 20u);
    EXPECT_EQ(json["compared_frames"]["a"], 20);
    EXPECT_EQ(json["compared_frames"]["b"], 5);
    const auto named = [](const auto& list, const char* key, const char* name) {
        for (const auto& one : list)
            if (one[key] == name) return one;
        return nlohmann::ordered_json();
    };
    const auto labels = named(json["differences"], "quantity", "labels_placed");
    EXPECT_EQ(labels["instants"], 20);
    EXPECT_EQ(labels["values_a"], 20);
    EXPECT_EQ(labels["values_b"], 5);
    const auto altitude = named(json["differences"], "quantity", "altitude");
    EXPECT_EQ(altitude["values_b"], 20) << "what is flown has a value at each instant";
    const auto fog = named(json["effects"], "name", "fog"), shadow = named(json["effects"], "name", "shadow");
    EXPECT_EQ(fog["frames_a"], 20);
    EXPECT_EQ(fog["frames_b"], 2);
    EXPECT_EQ(shadow["frames_b"], 0);
}

TEST(ComparisonJson, HasTheClosestPointOfEachWholeRun) {
    ComparedRun a = made_run("a", 10), b = with_log(made_run("b", 10), "a.log");
    a.frames[6].values[kHeightAboveTerrain] = 120;
    for (ComparedFrame& frame : b.frames) frame.values[kHeightAboveTerrain] = kUnknown;
    const auto json = comparison_json(compared_runs(a, b, {}));
    const auto& closest = json["closest"]["a"];
    EXPECT_EQ(closest["height_above_terrain_m"], 120);
    EXPECT_EQ(closest["time_s"], 6);
    EXPECT_NEAR(closest["lat_deg"].get<double>(), a.frames[6].latitude_deg, 1e-9);
    EXPECT_NEAR(closest["lon_deg"].get<double>(), 9, 1e-9);
    EXPECT_EQ(closest["phase"], "cruise");
    EXPECT_EQ(closest["searched"], "frames");
    EXPECT_TRUE(json["closest"]["b"].is_null()) << "its height is not known";
    EXPECT_TRUE(closest["unknown_s"].is_null()) << "it is of frames";
    a.closest = nlohmann::ordered_json::parse(
        R"({"unknown_s": 12, "left_out_s": 4, "by_height": [{"time_s": 3, "height_above_terrain_m": 9}]})");
    const auto searched = comparison_json(compared_runs(a, b, {}))["closest"]["a"];
    EXPECT_EQ(searched["unknown_s"], 12);
    EXPECT_EQ(searched["left_out_s"], 4);
}

TEST(ComparisonJson, SaysWhatHeightsRestOn) {
    ComparedRun a = made_run("a", 10), b = with_log(made_run("b", 8), "a.log");
    a.assumes_heights = true;
    b.frames[3].has_pressure_height = true;
    for (std::size_t n = 0; n < 6; ++n) b.frames[n].values[kHeightAboveTerrain] = kUnknown;
    const auto heights = comparison_json(compared_runs(a, b, {}))["heights"];
    EXPECT_EQ(heights["a"], nlohmann::ordered_json::parse(
                                R"({"are_assumed": true, "pressure_frames": 0, "ground_known_frames": 10, "frames": 10})"));
    EXPECT_EQ(heights["b"], nlohmann::ordered_json::parse(
                                R"({"are_assumed": false, "pressure_frames": 1, "ground_known_frames": 2, "frames": 8})"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_comparison_json
