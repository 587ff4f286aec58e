#include "host_sim/reports/clearance_json.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_clearance_json {
namespace {

using Json = nlohmann::json;

Clearance some_clearance() {
    Clearance clearance;
    clearance.height_above_terrain_m = 400;
    clearance.uncertainty = {10.0, 30.0, 40.0};
    clearance.nearest = {350, base::radians(90), base::radians(-45), {base::radians(46), base::radians(9), {1050}}, 1000};
    clearance.nearest_off_track_rad = base::radians(-30);
    clearance.level.right = clearance.nearest;
    return clearance;
}

TEST(ClearanceJson, SaysWhereTheNearestGroundIsAndHowSureThatIs) {
    const Json json = Json::parse(clearance_json(some_clearance()).dump());
    EXPECT_EQ(json["uncertainty"],
              Json({{"height_above_terrain_m", 50.0}, {"height_m", 30.0}, {"terrain_m", 40.0}, {"position_m", 10.0}}));
    EXPECT_EQ(json["nearest"]["distance_m"], 350);
    EXPECT_NEAR(json["nearest"]["bearing_deg"].get<double>(), 90, 1e-9);
    EXPECT_NEAR(json["nearest"]["off_track_deg"].get<double>(), -30, 1e-9);
    EXPECT_NEAR(json["nearest"]["elevation_deg"].get<double>(), -45, 1e-9);
    EXPECT_EQ(json["nearest"]["height_msl_m"], 1000);
    EXPECT_EQ(json["nearest"]["complete"], false);
    EXPECT_EQ(json["at_own_height"]["within_m"], 10000);
    EXPECT_TRUE(json["at_own_height"]["ahead"].is_null());
    EXPECT_EQ(json["at_own_height"]["right"]["distance_m"], 350);
}

TEST(ClearanceJson, WhatIsNotKnownIsNull) {
    EXPECT_TRUE(clearance_json(std::nullopt).is_null());
    Clearance clearance = some_clearance();
    clearance.uncertainty.terrain_m = std::nullopt;
    const Json json = Json::parse(clearance_json(clearance).dump());
    EXPECT_TRUE(json["uncertainty"]["height_above_terrain_m"].is_null());
    EXPECT_EQ(json["uncertainty"]["height_m"], 30);
}

TEST(ClearanceJson, IsInEveryRecord) {
    FrameResult result = test_support::frame_result(0, 3);
    EXPECT_TRUE(Json::parse(frame_record_json(result, {}))["clearance"].is_null());
    result.clearance = some_clearance();
    EXPECT_EQ(Json::parse(frame_record_json(result, {}))["clearance"]["nearest"]["distance_m"], 350);
}

}  // namespace
}  // namespace tedavis::host_sim::test_clearance_json
