#include "host_sim/scenario/scenario_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/input_file.hpp"
#include "host_sim/scenario/generated_attribute.hpp"
#include "host_sim/scenario/local_plane.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/wind.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scenario_scene {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

const GeoidEgm96& geoid() {
    static const GeoidEgm96 grid = GeoidEgm96::installed();
    return grid;
}

Scenario shipped() {
    const std::string path = test_support::source_dir() + "/configs/scenarios/default.toml";
    return parse_scenario(read_file(path), path);
}

MadeScene made(const Scenario& scenario, std::uint64_t seed) {
    return make_scenario_scene(scenario, ScenarioFlight(scenario, seed, geoid()), seed, [](auto, auto, auto) {});
}

std::vector<std::string> names_of(const SceneDraft& scene) {
    std::vector<std::string> names;
    for (const LayerDraft& layer : scene.layers) names.push_back(layer.name);
    return names;
}

const LayerDraft& layer_of(const SceneDraft& scene, const std::string& name) {
    for (const LayerDraft& layer : scene.layers)
        if (layer.name == name) return layer;
    throw std::runtime_error("no layer " + name);
}

const AttributeDraft& attribute_of(const LayerDraft& layer, const std::string& name) {
    for (const AttributeDraft& attribute : layer.attributes)
        if (attribute.name == name) return attribute;
    throw std::runtime_error("no attribute " + name);
}

TEST(ScenarioScene, HoldsTheSceneFileWithTheWeatherInPlaceOfItsOwn) {
    const MadeScene scene = made(shipped(), 1);
    const std::vector<std::string> names = names_of(scene.draft);
    EXPECT_THAT(names, IsSupersetOf({"wind", "storm", "radar", "gusts", "flight", "no_go", "obstacles", "places", "traffic"}));
    for (const std::string& name : names) EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    EXPECT_EQ(scene.draft.origin, kGeneratedOrigin);
    EXPECT_EQ(scene.draft.name, "default");
    for (const char* name : {"wind", "storm", "radar", "gusts", "flight"})
        EXPECT_EQ(layer_of(scene.draft, name).source, kGeneratedOrigin);
    EXPECT_EQ(layer_of(scene.draft, "wind").times_ns.size(), 3u);
    EXPECT_EQ(layer_of(scene.draft, "storm").feature_count(), 9u);
}

/// The flight takes off from and lands on the runway that the scene shows.
TEST(ScenarioScene, HasItsRunwayWhereTheScenarioHasTheStrip) {
    const Scenario scenario = shipped();
    const MadeScene scene = made(scenario, 1);
    const LayerDraft& runways = layer_of(scene.draft, "runways");
    ASSERT_EQ(runways.feature_count(), 1u);
    ASSERT_GE(runways.points.size(), 2u);
    const scene::ScenePoint &first = runways.points.front(), &other = runways.points[1];
    const earth::Geodetic from{first.latitude_rad, first.longitude_rad, {}}, to{other.latitude_rad, other.longitude_rad, {}},
        middle{(from.latitude_rad + to.latitude_rad) / 2, (from.longitude_rad + to.longitude_rad) / 2, {}};
    const LandingStrip& strip = scenario.strip;
    EXPECT_LT(earth::surface_distance_m(middle, {strip.latitude_rad, strip.longitude_rad, {}}), 2);
    EXPECT_NEAR(earth::surface_distance_m(from, to), strip.length_m, 2);
    const double east = earth::angle_difference(to.longitude_rad, from.longitude_rad) * std::cos(middle.latitude_rad);
    const double along = std::atan2(east, to.latitude_rad - from.latitude_rad);
    EXPECT_LT(std::fabs(std::sin(along - strip.heading_rad)), 0.01);
}

/// Else the approach lights would be all white while it is on its path.
TEST(ScenarioScene, HasApproachLightsOfTheGlidePathThatIsFlown) {
    const Scenario scenario = shipped();
    const MadeScene scene = made(scenario, 1);
    const double shown_rad = attribute_of(layer_of(scene.draft, "runways"), "glide_path").values.at(0);
    std::size_t finals = 0;
    for (const Leg& leg : scenario.legs) {
        if (leg.kind != LegKind::final_leg) continue;
        EXPECT_NEAR(leg.glide_rad, shown_rad, 1e-6);
        ++finals;
    }
    EXPECT_EQ(finals, 2u);
}

TEST(ScenarioScene, IsTheSameBitForBitForEqualSeedsOnly) {
    const std::vector<std::uint8_t> one = sdb_bytes(made(shipped(), 1).draft);
    EXPECT_EQ(one, sdb_bytes(made(shipped(), 1).draft));
    const SceneDraft a = made(shipped(), 1).draft, b = made(shipped(), 2).draft;
    EXPECT_NE(attribute_of(layer_of(a, "wind"), "east").values, attribute_of(layer_of(b, "wind"), "east").values);
    EXPECT_NE(attribute_of(layer_of(a, "storm"), "intensity").values, attribute_of(layer_of(b, "storm"), "intensity").values);
    EXPECT_EQ(layer_of(a, "places").points.size(), layer_of(b, "places").points.size());
}

TEST(ScenarioScene, GivesTheFlightTheWindThatItMeets) {
    const Scenario scenario = shipped();
    const ScenarioFlight flight(scenario, 1, geoid());
    const MadeScene scene = make_scenario_scene(scenario, flight, 1, [](auto, auto, auto) {});
    const LayerDraft& planned = layer_of(scene.draft, "flight");
    const std::vector<float>& speed = attribute_of(planned, "wind_speed").values;
    const std::vector<float>& head = attribute_of(planned, "head_wind").values;
    const std::vector<float>& cross = attribute_of(planned, "cross_wind").values;
    for (std::size_t n = 0; n < speed.size(); ++n) {
        ASSERT_TRUE(std::isfinite(speed[n]));
        ASSERT_TRUE(attribute_of(planned, "wind_speed").uncertainties[n].is_known());
        if (std::isnan(head[n])) continue;  // it stands
        EXPECT_NEAR(std::hypot(static_cast<double>(head[n]), static_cast<double>(cross[n])), static_cast<double>(speed[n]), 1e-3);
    }
    const auto highest = std::max_element(planned.points.begin(), planned.points.end(),
                                          [](const auto& a, const auto& b) { return a.height_m < b.height_m; });
    EXPECT_NEAR(static_cast<double>(speed[static_cast<std::size_t>(highest - planned.points.begin())]),
                flight.air().wind_speed_mps, 3);
    EXPECT_TRUE(scene.notes.empty());
}

/// By the posts within 4 km of the strip in the level of 300 m, and the file's own numbers.
TEST(ScenarioScene, HasTheEnvironmentsWindAtTheStripWithinItsSpread) {
    const Scenario scenario = shipped();
    const Environment& air = scenario.environment;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const MadeScene scene = made(scenario, seed);
        const LayerDraft& wind = layer_of(scene.draft, "wind");
        const std::vector<float>&east = attribute_of(wind, "east").values, &north = attribute_of(wind, "north").values;
        scene::WindMean mean;
        for (std::uint32_t row = 0; row < wind.grid.rows; ++row)
            for (std::uint32_t column = 0; column < wind.grid.columns; ++column) {
                const earth::Geodetic post{
                    wind.grid.north_rad - row * wind.grid.step_lat_rad, wind.grid.west_rad + column * wind.grid.step_lon_rad, {}};
                const earth::Geodetic strip{scenario.strip.latitude_rad, scenario.strip.longitude_rad, {}};
                const std::size_t n = (std::size_t{wind.grid.rows} + row) * wind.grid.columns + column;
                if (earth::surface_distance_m(post, strip) < 4'000)
                    mean.add(static_cast<double>(east[n]), static_cast<double>(north[n]));
            }
        const scene::Wind found = mean.mean();
        EXPECT_NEAR(found.speed_mps, air.wind_speed_mps, air.wind_speed_spread_mps + 0.3) << "seed " << seed;
        EXPECT_LT(std::abs(earth::angle_difference(found.from_rad, air.wind_from_rad)),
                  air.wind_from_spread_rad + base::radians(4))
            << "seed " << seed;
    }
}

/// Whatever the seed: the shipped storm is to be seen, not to be flown into, and never comes over the strip.
TEST(ScenarioScene, KeepsTheStormOffTheStripAndTheFlight) {
    const Scenario scenario = shipped();
    const LandingStrip& strip = scenario.strip;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const ScenarioFlight flight(scenario, seed, geoid());
        const MadeScene scene = make_scenario_scene(scenario, flight, seed, [](auto, auto, auto) {});
        const LayerDraft &storm = layer_of(scene.draft, "storm"), &planned = layer_of(scene.draft, "flight");
        const LocalPlane plane(strip.latitude_rad, strip.longitude_rad);
        double to_strip_m = 1e9, to_flight_m = 1e9;
        for (const scene::ScenePoint& point : planned.points) {
            const double seconds = 1e-9 * static_cast<double>(point.time_ns - scenario.start.ns);
            for (std::size_t cell = 0; cell < storm.feature_count(); ++cell) {
                const double gone_m = static_cast<double>(attribute_of(storm, "speed").values[cell]) * seconds;
                const auto toward = static_cast<double>(attribute_of(storm, "toward").values[cell]);
                for (std::uint32_t corner = storm.starts[cell]; corner < storm.starts[cell + 1]; ++corner) {
                    const earth::Geodetic here{
                        storm.points[corner].latitude_rad + gone_m * std::cos(toward) * plane.latitude_per_m(),
                        storm.points[corner].longitude_rad + gone_m * std::sin(toward) * plane.longitude_per_m(),
                        {}};
                    to_strip_m =
                        std::min(to_strip_m, earth::surface_distance_m(here, {strip.latitude_rad, strip.longitude_rad, {}}));
                    to_flight_m =
                        std::min(to_flight_m, earth::surface_distance_m(here, {point.latitude_rad, point.longitude_rad, {}}));
                }
            }
        }
        EXPECT_GT(to_strip_m, 4'000) << "seed " << seed;
        EXPECT_LT(to_strip_m, 15'000) << "seed " << seed;
        EXPECT_GT(to_flight_m, 1'000) << "seed " << seed;
    }
}

TEST(ScenarioScene, NeedsNeitherSceneFileNorWeather) {
    Scenario scenario = shipped();
    scenario.scene.clear();
    scenario.weather.reset();
    EXPECT_THAT(names_of(made(scenario, 1).draft), ElementsAre("flight"));
    scenario.weather = shipped().weather;
    scenario.weather->storm.cells = 0;
    const SceneDraft calm = made(scenario, 1).draft;
    EXPECT_THAT(names_of(calm), ElementsAre("flight", "wind", "storm", "radar", "gusts"));
    scenario.weather->gust.members = 0;
    EXPECT_THAT(names_of(made(scenario, 1).draft), ElementsAre("flight", "wind", "storm", "radar"));
    EXPECT_FALSE(sdb_bytes(calm).empty());
}

TEST(ScenarioScene, TakesTheWindOfTheSceneFileWhereNoneIsDrawn) {
    Scenario scenario = shipped();
    scenario.weather.reset();
    const MadeScene scene = made(scenario, 1);
    EXPECT_THAT(names_of(scene.draft), Contains("wind"));
    EXPECT_EQ(layer_of(scene.draft, "wind").levels_m.size(), 0u) << "its own";
    EXPECT_EQ(attribute_of(layer_of(scene.draft, "flight"), "wind_speed").values.size(),
              layer_of(scene.draft, "flight").points.size());
}

TEST(ScenarioScene, NamesTheFaultOfASceneFile) {
    const test_support::TemporaryFolder place;
    Scenario scenario = shipped();
    scenario.scene = place.write("s.toml", "name = \"s\"\n[[layer]]\nname = \"a\"\nsource = \"nothing.csv\"\nsurce = 1\n");
    test_support::expect_user_error([&] { (void)made(scenario, 1); }, "s.toml:5");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario_scene
