#include "host_sim/reports/frame_record_json.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_frame_record_json {
namespace {

using Json = nlohmann::json;

const base::Time kOrigin{2'500'000'000};

Json parsed(const FrameResult& result) { return Json::parse(frame_record_json(result, kOrigin)); }

TEST(FrameRecordJson, IsOneLineThatSaysEverything) {
    const FrameResult result = test_support::frame_result(42, 10);
    EXPECT_EQ(frame_record_json(result, kOrigin).find('\n'), std::string::npos);
    const Json json = parsed(result);
    EXPECT_EQ(json["frame"], 42);
    EXPECT_EQ(json["time_s"], 7.5);
    EXPECT_EQ(json["hash"], "0123456789abcdef");
    EXPECT_EQ(json["phase"], "takeoff");
    EXPECT_EQ(json["sub_phase"], "first_climb");
    EXPECT_EQ(json["phase_source"], "can");
    EXPECT_NEAR(json["own_ship"]["lat_deg"].get<double>(), 46.5, 1e-12);
    EXPECT_NEAR(json["own_ship"]["lon_deg"].get<double>(), 9.75, 1e-12);
    EXPECT_EQ(json["own_ship"]["alt_msl_m"], 1510);
    EXPECT_EQ(json["own_ship"]["alt_ellipsoid_m"], 1560);
    EXPECT_NEAR(json["own_ship"]["heading_deg"].get<double>(), 270, 1e-12);
    EXPECT_NEAR(json["own_ship"]["roll_deg"].get<double>(), -10, 1e-12);
    EXPECT_EQ(json["own_ship"]["state"], "valid");
    EXPECT_EQ(json["signals"].size(), flight::kSignalCount);
    EXPECT_EQ(json["elements"].size(), policy::kElementCount);
    EXPECT_EQ(json["elements"]["slip"], "flagged");
    EXPECT_EQ(json["terrain"], Json({{"tau_px", 1},
                                     {"tau_reached_px", 1.5},
                                     {"limit", "triangles"},
                                     {"worst_error_px", 0.75},
                                     {"worst_chunk", "2/3/4"},
                                     {"triangles", 12345},
                                     {"chunks", 67},
                                     {"pending", 8},
                                     {"renderer", "raster"},
                                     {"renderer_reason", "the device's lane is es2"}}));
    EXPECT_FALSE(json["terrain"].contains("renderer_ms")) << "there was no choice";
    EXPECT_EQ(json["view"], Json({{"mode", "3d"}, {"transition", 1.0}}));
    EXPECT_EQ(json["bytes"], Json({{"cpu", 100}, {"gpu", 200}, {"cpu_budget", 1000}, {"gpu_budget", 2000}, {"uploaded", 50}}));
    EXPECT_EQ(json["ms"], Json({{"plan", 1}, {"draw", 2}, {"total", 3}}));
    EXPECT_EQ(json["latency_ms"], 12);
}

TEST(FrameRecordJson, StatesBothCostsWhereTheRendererWasChosen) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.terrain.triangles_ms = 7.5;
    result.record.terrain.rays_ms = 9.25;
    EXPECT_EQ(parsed(result)["terrain"]["renderer_ms"], Json({{"raster", 7.5}, {"trace", 9.25}}));
}

TEST(FrameRecordJson, StatesTheAlertsAndWhatTheyAreOf) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.alerts.height_above_terrain_m = std::nan("");
    Json alerts = parsed(result)["alerts"];
    EXPECT_EQ(alerts["terrain"], Json({{"level", "none"},
                                       {"watching", false},
                                       {"clearance_m", 0.0},
                                       {"height_above_terrain_m", nullptr},
                                       {"zone", nullptr}}));
    EXPECT_EQ(alerts["obstacles"], Json({{"level", "none"}, {"count", 0}, {"ahead", Json::array()}}));
    display::AlertRecord& stated = result.record.alerts;
    stated = {policy::TerrainAhead::warning, policy::TerrainAhead::caution, {}, true, 30.5, 250};
    stated.obstacles.add(2, 7, 41.25, std::numeric_limits<double>::infinity());
    policy::TerrainAlertZone& zone = result.record.alert_zone;
    zone.alert = policy::TerrainAhead::warning;
    zone.north_mps = zone.east_mps = 50;
    zone.radius_m = 60, zone.radius_mps = 2;
    zone.floor_msl_m = 900, zone.floor_mps = -1;
    zone.until_s = 40;
    alerts = parsed(result)["alerts"];
    EXPECT_EQ(alerts["terrain"]["level"], "warning");
    EXPECT_EQ(alerts["terrain"]["clearance_m"], 30.5);
    EXPECT_EQ(alerts["terrain"]["height_above_terrain_m"], 250.0);
    EXPECT_EQ(alerts["terrain"]["zone"]["width_m"], Json({60.0, 140.0}));
    EXPECT_EQ(alerts["terrain"]["zone"]["floor_msl_m"], Json({900.0, 860.0}));
    EXPECT_NEAR(alerts["terrain"]["zone"]["track_deg"].get<double>(), 45, 1e-9);
    EXPECT_EQ(
        alerts["obstacles"],
        Json({{"level", "caution"},
              {"count", 1},
              {"ahead", {{{"layer", 2}, {"feature", 7}, {"level", "caution"}, {"seconds", 41.2}, {"straight_ahead", false}}}}}));
}

TEST(FrameRecordJson, SaysByWhichTimeDataAreValid) {
    FrameResult result = test_support::frame_result(0, 3);
    EXPECT_EQ(parsed(result)["utc"], Json({{"time_s", nullptr}, {"confirmed", false}}));
    result.record.flight_time = {{1'780'315'200'500'000'000}, true, true};
    EXPECT_EQ(parsed(result)["utc"], Json({{"time_s", 1780315200.5}, {"confirmed", true}}));
}

TEST(FrameRecordJson, HasEveryKeyOfTheContract) {
    const Json json = parsed(test_support::frame_result(0, 3));
    for (const char* key : {"frame",   "time_s",   "utc",   "hash",    "phase",        "sub_phase", "phase_source", "own_ship",
                            "signals", "elements", "flags", "view",    "terrain",      "alerts",    "data",         "labels",
                            "bytes",   "governor", "foci",  "effects", "presentation", "ms",        "latency_ms"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const char* key : {"placed", "suppressed", "changed"}) EXPECT_TRUE(json["labels"].contains(key)) << key;
    for (const char* aspect : {"terrain", "data", "uncertainty"})
        for (const char* key : {"technique", "detail", "weight"})
            EXPECT_TRUE(json["presentation"][aspect].contains(key)) << aspect << key;
}

TEST(FrameRecordJson, TellsTheMapAndTheWayToIt) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.view = {design::ViewMode::map, 0.25};
    EXPECT_EQ(parsed(result)["view"], Json({{"mode", "map"}, {"transition", 0.25}}));
}

TEST(FrameRecordJson, TellsTheLightOfTheSymbology) {
    FrameResult result = test_support::frame_result(0, 3);
    EXPECT_EQ(parsed(result)["symbology_light"], "day");
    result.record.symbology_light = design::SymbologyLight::night;
    EXPECT_EQ(parsed(result)["symbology_light"], "night");
    EXPECT_TRUE(parsed(result)["light"].is_object()) << "the light of the terrain is another key";
}

TEST(FrameRecordJson, TellsLabelsAndWeights) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.labels = {5, 7, 2, 1};
    ASSERT_TRUE(result.record.weights.try_push_back({display::Name("obstacles"), 0.75, 0.5}));
    const Json json = parsed(result);
    EXPECT_EQ(json["legend"], Json({{"show", "key"}, {"entries", 0}, {"left_out", 0}}));
    EXPECT_EQ(json["labels"], Json({{"placed", 5}, {"suppressed", 7}, {"changed", 2}, {"decluttered", 1}}));
    EXPECT_EQ(json["presentation"]["weights"]["obstacles"], Json({{"weight", 0.75}, {"stated", 0.5}}));
}

TEST(FrameRecordJson, TellsWhatGivesWayForTheBudgetOfClutter) {
    FrameResult result = test_support::frame_result(0, 3);
    EXPECT_TRUE(parsed(result)["clutter"].is_null()) << "without a budget";
    display::ClutterRecord& clutter = result.record.clutter;
    clutter.budget = 0.25;
    EXPECT_EQ(parsed(result)["clutter"],
              Json({{"budget", 0.25}, {"is_measured", false}, {"regions", Json::array()}, {"decluttered_roles", Json::array()}}));
    clutter.measured.whole.is_known = clutter.measured.least.is_known = true;
    clutter.measured.whole.measure[9] = 0.5f;
    clutter.measured.least.measure[9] = 0.375f;
    clutter.left.factor[9] = 0.25f;
    clutter.left.factor[47] = 0.5f;  // held from before
    clutter.roles = 1u << static_cast<unsigned>(scene::LayerRole::wind);
    const Json json = parsed(result)["clutter"];
    EXPECT_EQ(json["decluttered_roles"], Json({"wind"}));
    ASSERT_EQ(json["regions"].size(), 2u);
    EXPECT_EQ(json["regions"][0],
              Json({{"column", 1}, {"row", 1}, {"clutter", 0.5}, {"least", 0.375}, {"reached", nullptr}, {"detail", 0.25}}));
    EXPECT_EQ(json["regions"][1]["row"], 5);
}

TEST(FrameRecordJson, TellsTheLight) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.light = {policy::LightSource::fixed, 0, base::kPi / 2};
    EXPECT_EQ(parsed(result)["light"], Json({{"source", "fixed"}, {"azimuth_deg", 0.0}, {"elevation_deg", 90.0}}));
    for (const auto& [source, name] : {std::pair{policy::LightSource::sun, "sun"},
                                       {policy::LightSource::no_date, "fixed_no_date"},
                                       {policy::LightSource::sun_too_low, "fixed_sun_too_low"}}) {
        result.record.light.source = source;
        EXPECT_EQ(parsed(result)["light"]["source"], name);
    }
}

TEST(FrameRecordJson, TellsByHowMuchTheBandsAreLowered) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.bands = {25, 10, 11, false, true};
    EXPECT_EQ(parsed(result)["warning_bands"], Json({{"lowered_m", 25.0},
                                                     {"position_sigma_m", 10.0},
                                                     {"terrain_sigma_m", 11.0},
                                                     {"position_assumed", false},
                                                     {"terrain_assumed", true}}));
}

TEST(FrameRecordJson, FlagsAndEffectsAreLists) {
    FrameResult result = test_support::frame_result(0, 3);
    EXPECT_EQ(parsed(result)["flags"], Json::array());
    ASSERT_TRUE(result.record.flags.try_push_back(display::Name("altitude.stale")));
    display::EffectRecord effect;
    effect.name = display::Name("haze");
    effect.state = display::EffectState::replaced;
    effect.replaced_by = display::Name("tint");
    effect.draws = 3;
    ASSERT_TRUE(result.record.effects.try_push_back(effect));
    const Json json = parsed(result);
    EXPECT_EQ(json["flags"], Json({"altitude.stale"}));
    EXPECT_EQ(json["governor"]["deadline_ms"], 0);
    EXPECT_EQ(json["governor"]["changed"], false);
    EXPECT_EQ(json["governor"]["tau_factor"], 1);
    EXPECT_TRUE(json["governor"]["given_up"].empty());
    EXPECT_EQ(json["effects"][0]["name"], "haze");
    EXPECT_EQ(json["effects"][0]["state"], "replaced");
    EXPECT_EQ(json["effects"][0]["replaced_by"], "tint");
    EXPECT_EQ(json["effects"][0]["draws"], 3);
}

TEST(FrameRecordJson, TellsTheFoci) {
    FrameResult result = test_support::frame_result(0, 3);
    EXPECT_EQ(parsed(result)["foci"], Json::array());
    display::FocusRecord here, gone;
    here.name = "HERE";
    here.is_shown = true;
    here.latitude_rad = base::kPi / 4;
    here.in_focus = 3;
    here.low = 4;
    here.high = 5;
    here.sight = "seen";
    ASSERT_TRUE(here.values.try_push_back({"wind", "speed", 1.5, 2.5, 7}));
    gone.reason = "the own ship's position is not known";
    ASSERT_TRUE(result.record.foci.try_push_back(here) && result.record.foci.try_push_back(gone));
    const Json foci = parsed(result)["foci"];
    EXPECT_EQ(foci[0]["name"], "HERE");
    EXPECT_EQ(foci[0]["latitude_deg"], 45);
    EXPECT_EQ(foci[0]["in_focus"], 3);
    EXPECT_EQ(foci[0]["interval"], Json({4.0, 5.0}));
    EXPECT_EQ(foci[0]["values"][0], Json({{"layer", "wind"}, {"attribute", "speed"}, {"count", 7}, {"interval", {1.5, 2.5}}}));
    EXPECT_EQ(foci[1]["shown"], false);
    EXPECT_EQ(foci[1]["reason"], "the own ship's position is not known");
    EXPECT_EQ(foci[1]["interval"], nullptr);
    EXPECT_FALSE(foci[1].contains("latitude_deg")) << "it is nowhere";
}

TEST(FrameRecordJson, TellsObstaclesWithTheLayersOnly) {
    FrameResult result = test_support::frame_result(1, 0);
    display::ObstaclePlace seen, hidden;
    seen.name = base::FixedString<31>("Mast 1");
    seen.state = display::ObstacleState::drawn;
    seen.ahead_s = 12;
    seen.box = {10, 20, 30, 40};
    hidden.state = display::ObstacleState::hidden;
    EXPECT_TRUE(result.obstacles.try_push_back(seen) && result.obstacles.try_push_back(hidden));
    EXPECT_FALSE(nlohmann::json::parse(frame_record_json(result, base::Time{})).contains("obstacles"));
    result.has_layers = true;
    const auto obstacles = nlohmann::json::parse(frame_record_json(result, base::Time{})).at("obstacles");
    ASSERT_EQ(obstacles.size(), 2u);
    EXPECT_EQ(obstacles[0], nlohmann::json::parse(
                                R"({"name":"Mast 1","feature":0,"state":"drawn","ahead_s":12.0,"box":[10.0,20.0,40.0,60.0]})"));
    EXPECT_EQ(obstacles[1].at("state"), "hidden");
    EXPECT_TRUE(obstacles[1].at("box").is_null());
}

TEST(FrameRecordJson, WhatIsNotKnownIsNull) {
    FrameResult result = test_support::frame_result(0, 3);
    result.record.own_ship.height_is_geometric = false;
    result.record.altitude_msl_m = std::nan("");
    result.latency_ms = INFINITY;
    const Json json = parsed(result);
    EXPECT_TRUE(json["own_ship"]["alt_ellipsoid_m"].is_null());
    EXPECT_TRUE(json["own_ship"]["alt_msl_m"].is_null());
    EXPECT_TRUE(json["latency_ms"].is_null());
}

TEST(FrameRecordJson, ALostOwnShipHasNoPlace) {
    FrameResult result = test_support::frame_result(0, 3);
    for (const auto state :
         {base::SignalState::missing, base::SignalState::lost, base::SignalState::stale, base::SignalState::valid}) {
        result.record.own_ship.state = state;
        const Json own = parsed(result)["own_ship"];
        const bool held = state == base::SignalState::stale || state == base::SignalState::valid;
        for (const char* key : {"lat_deg", "lon_deg", "alt_msl_m", "alt_ellipsoid_m"})
            EXPECT_EQ(own[key].is_number(), held) << key << ' ' << own["state"];
        EXPECT_TRUE(own["heading_deg"].is_number());
    }
}

TEST(FrameRecordJson, NumbersReadBackToTheSameBits) {
    FrameResult result = test_support::frame_result(0, 3);
    for (const double value : {0.1, 1.0 / 3, 46.123456789012345, 1e-300, 123456789.123456789}) {
        result.latency_ms = value;
        EXPECT_EQ(parsed(result)["latency_ms"].get<double>(), value);
    }
}

TEST(FrameRecordJson, HashesHaveSixteenDigits) {
    EXPECT_EQ(hash_text(0), "0000000000000000");
    EXPECT_EQ(hash_text(0xABCu), "0000000000000abc");
    EXPECT_EQ(hash_text(~std::uint64_t{0}), "ffffffffffffffff");
}

}  // namespace
}  // namespace tedavis::host_sim::test_frame_record_json
