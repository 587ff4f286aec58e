#include "host_sim/reports/closest_json.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/reports/closest_report.hpp"

namespace tedavis::host_sim::test_closest_json {
namespace {

using Json = nlohmann::json;

TEST(ClosestJson, SaysWhenWhereAndWhatTheDisplayShowed) {
    const Json json = Json::parse(closest_json(test_support::closest_report()).dump());
    EXPECT_EQ(json["sample_step_s"], 0.5);
    EXPECT_EQ(json["left_out_s"], 60);
    ASSERT_EQ(json["by_height"].size(), 1u);
    const Json& one = json["by_height"][0];
    EXPECT_EQ(one["time_s"], 83.2);
    EXPECT_EQ(one["utc"], "2023-11-14T14:23:05.2Z");
    EXPECT_NEAR(one["lat_deg"].get<double>(), 46.7312, 1e-9);
    EXPECT_EQ(one["height_above_terrain_m"], 95);
    EXPECT_NEAR(one["uncertainty"]["height_above_terrain_m"].get<double>(), 24.083, 1e-3);
    EXPECT_EQ(one["nearest"]["distance_m"], 80);
    EXPECT_EQ(one["phase"], "cruise");
    EXPECT_EQ(one["alert"], "caution");
    EXPECT_EQ(one["design"], "cruise");
    EXPECT_EQ(one["frame"], 42);
    EXPECT_EQ(one["picture"], "frames/000042.png");
    EXPECT_EQ(json["by_distance"].size(), 1u);
}

TEST(ClosestJson, IsNullWhereItWasNotSearched) { EXPECT_TRUE(closest_json({}).is_null()); }

TEST(ClosestJson, WithoutADateTheTimeIsThatOfTheLog) {
    StatedClosest closest = test_support::closest_report().by_height.front();
    EXPECT_EQ(when_text(closest), "14:23:05.2 UTC");
    closest.utc.clear();
    EXPECT_EQ(when_text(closest), "83.2 s");
}

}  // namespace
}  // namespace tedavis::host_sim::test_closest_json
