#include "host_sim/reports/run_summary.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tedavis::host_sim::test_run_summary {
namespace {

using Json = nlohmann::json;

TEST(RunSummary, MedianAndPercentileOfFrameTimes) {
    EXPECT_EQ(frame_times({}).median_ms, 0);
    EXPECT_EQ(frame_times({}).p99_ms, 0);
    EXPECT_EQ(frame_times({7}).median_ms, 7);
    EXPECT_EQ(frame_times({7}).p99_ms, 7);
    EXPECT_EQ(frame_times({3, 1, 2}).median_ms, 2);
    EXPECT_EQ(frame_times({4, 1, 2, 3}).median_ms, 2.5);
    std::vector<double> hundred;
    for (int i = 100; i >= 1; --i) hundred.push_back(i);
    EXPECT_EQ(frame_times(hundred).p99_ms, 99);
    EXPECT_EQ(frame_times(hundred).median_ms, 50.5);
}

RunSummary full_summary() {
    RunSummary s;
    s.frames = 17;
    s.fps_median = 31.5;
    s.device = "es3-mid";
    s.log = "flight.log";
    s.width = 640;
    s.height = 480;
    s.can = {1000, 900, 80, 15, 5, 2, 3, {21, 22, 23, 24, 25, 26}};
    EffectCount haze;
    haze.name = "haze";
    haze.asked = haze.skipped = 4;
    haze.reasons = {{"too thin to be seen", 4}};
    s.effects = {haze};
    s.interrupted = true;
    s.notes = {"line 7 is broken"};
    s.warnings = {{"terrain.outside", "all 17 frames lie outside", 17}};
    s.worst_error_px = 0.5;
    EXPECT_EQ(error_text(s), "no terrain drawn");
    s.terrain_frames = 3;
    EXPECT_EQ(error_text(s), "worst terrain error 0.50 px");
    s.worst_start_error_px = 431299;
    s.terrain_alerts = {0.5, 40, 20.5, 4, 3, 2, 1};
    s.terrain_alerts.frames_by[0] = 30;
    s.terrain_alerts.hours_by[0] = 0.125;
    s.terrain_alerts.frames_by[static_cast<std::size_t>(AlertHindrance::outside)] = 90;
    s.terrain_alerts.hours_by[static_cast<std::size_t>(AlertHindrance::outside)] = 0.375;
    s.closest.assumes_heights = true;
    return s;
}

TEST(RunSummary, HasEveryKeyOfTheContract) {
    const Json json = Json::parse(run_summary_json(full_summary(), {}));
    for (const char* key : {"frames",
                            "fps_median",
                            "ms_p99",
                            "heap_allocations_after_start",
                            "terrain_frames",
                            "frames_over_void",
                            "worst_error_px",
                            "worst_start_error_px",
                            "terrain_alerts",
                            "assumes_heights",
                            "gl_calls_outside_device",
                            "device",
                            "design",
                            "aircraft",
                            "palette",
                            "light",
                            "terrain",
                            "scene",
                            "log",
                            "switches",
                            "size",
                            "costs",
                            "governor",
                            "gl",
                            "version",
                            "can",
                            "effects"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["frames"], 17);
    EXPECT_EQ(json["fps_median"], 31.5);
    EXPECT_EQ(json["size"], "640x480");
    EXPECT_EQ(
        json["can"],
        Json({{"frames", 1000},
              {"decoded", 900},
              {"alien", 80},
              {"errors", 15},
              {"dropped", 5},
              {"broken_lines", 2},
              {"other_lines", 3},
              {"traffic",
               {{"reports", 21}, {"incomplete", 22}, {"repeated", 23}, {"refused", 24}, {"outdated", 25}, {"no_room", 26}}}}));
    EXPECT_EQ(json["governor"]["frames"], 0);
    EXPECT_TRUE(json["governor"]["least_s_between_changes"].is_null());
    EXPECT_EQ(json["governor"]["frames_at_quality_level"].size(), effects::kQualityLevelCount);
    EXPECT_EQ(json["effects"].size(), 1u);
    EXPECT_EQ(json["effects"][0]["skipped"], 4);
    EXPECT_EQ(json["effects"][0]["reasons"][0], Json({{"why", "too thin to be seen"}, {"frames", 4}}));
    EXPECT_FALSE(json.contains("accuracy_overlay")) << "only a run with it states it";
    EXPECT_EQ(json["interrupted"], true);
    EXPECT_EQ(json["notes"], Json({"line 7 is broken"}));
    EXPECT_EQ(json["warnings"].size(), 1u);
    EXPECT_EQ(json["warnings"][0], Json({{"name", "terrain.outside"}, {"text", "all 17 frames lie outside"}, {"count", 17}}));
    EXPECT_EQ(Json::parse(run_summary_json({}, {}))["warnings"], Json::array());
    EXPECT_EQ(json["worst_error_px"], 0.5);
    EXPECT_EQ(json["worst_start_error_px"], 431299);
    EXPECT_EQ(json["terrain_alerts"], Json({{"hours", 0.5},
                                            {"possible_hours", 0.125},
                                            {"frames", 120},
                                            {"possible_frames", 30},
                                            {"impossible", {{"outside", {{"frames", 90}, {"hours", 0.375}}}}},
                                            {"seconds_caution", 40.0},
                                            {"seconds_warning", 20.5},
                                            {"count", 4},
                                            {"false_count", 3},
                                            {"false_per_hour", 6.0},
                                            {"warnings", 2},
                                            {"false_warnings", 1}}));
    EXPECT_EQ(json["assumes_heights"], true) << "though no closest point was searched";
}

TEST(RunSummary, SaysWhichGhostsWereShown) {
    RunSummary summary = full_summary();
    EXPECT_FALSE(Json::parse(run_summary_json(summary, {})).contains("ghosts"));
    summary.ghosts = {{"a.log", "a", GhostAlign::takeoff, -12.5, {{3, 46, 9}, {40, 46.1, 9}}},
                      {"b.log", "b", GhostAlign::place, {}, {{0, 46, 9}, {7, 46.1, 9}}}};
    const Json ghosts = Json::parse(run_summary_json(summary, {})).at("ghosts");
    EXPECT_EQ(ghosts.at(0), Json::parse(R"({"log": "a.log", "name": "a", "align": "takeoff", "shift_s": -12.5, "from_s": 3,
                                            "to_s": 40})"));
    EXPECT_TRUE(ghosts.at(1).at("shift_s").is_null()) << "by place it varies";
}

TEST(RunSummary, TheStartsErrorIsSaidBesideTheWorst) {
    EXPECT_EQ(start_error_text(full_summary()), "; while its first chunks arrived, 431299.00 px");
    EXPECT_EQ(start_error_text({}), "");
}

TEST(RunSummary, ListsTheBudgetLineByLine) {
    base::BudgetTable memory;
    base::BudgetLine line;
    line.name = base::FixedString<31>("terrain.chunks");
    line.owner = base::FixedString<31>("terrain");
    line.reason = base::FixedString<95>("the visible set");
    line.kind = base::MemoryKind::gpu;
    line.bytes = 4096;
    line.use.in_use = 1000;
    line.use.high_water = 2000;
    line.use.refused = 3;
    ASSERT_TRUE(memory.try_add(line));
    const Json json = Json::parse(run_summary_json(full_summary(), memory));
    EXPECT_EQ(json["memory"], Json({{{"name", "terrain.chunks"},
                                     {"owner", "terrain"},
                                     {"reason", "the visible set"},
                                     {"kind", "gpu"},
                                     {"bytes", 4096},
                                     {"in_use", 1000},
                                     {"high_water", 2000},
                                     {"refused", 3}}}));
}

TEST(RunSummary, SurvivesNamesThatAreNoText) {
    RunSummary summary = full_summary();
    summary.log = "caf\xE9.log";
    EXPECT_EQ(Json::parse(run_summary_json(summary, {}))["log"], "caf\xEF\xBF\xBD.log");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_summary
