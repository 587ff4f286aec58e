#include "host_sim/scenario/planned_flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/input_file.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_planned_flight {
namespace {

class PlannedFlight : public ::testing::Test {
protected:
    static const Scenario& shipped() {
        static const Scenario scenario =
            parse_scenario(read_file(test_support::source_dir() + "/configs/scenarios/default.toml"), "default.toml");
        return scenario;
    }
    static const ScenarioFlight& flight() {
        static const GeoidEgm96 geoid = GeoidEgm96::installed();
        static const ScenarioFlight flown(shipped(), 1, geoid);
        return flown;
    }
    static const LayerDraft& layer() {
        static const LayerDraft made = make_flight_layer(flight(), shipped().strip);
        return made;
    }
    static const AttributeDraft& attribute(const std::string& name) {
        for (const AttributeDraft& attribute : layer().attributes)
            if (attribute.name == name) return attribute;
        throw std::runtime_error("no attribute " + name);
    }
};

TEST_F(PlannedFlight, IsWhereTheAircraftWillBe) {
    ASSERT_EQ(layer().feature_count(), 1u);
    EXPECT_EQ(layer().role, scene::LayerRole::trajectory);
    EXPECT_EQ(layer().points.front().time_ns, flight().begin().ns);
    EXPECT_EQ(layer().points.back().time_ns, flight().end().ns);
    std::int64_t before_ns = flight().begin().ns - 1;
    for (std::size_t n = 0; n < layer().points.size(); ++n) {
        const scene::ScenePoint& point = layer().points[n];
        EXPECT_GT(point.time_ns, before_ns);
        EXPECT_LE(point.time_ns - before_ns, 2'000'000'001);
        before_ns = point.time_ns;
        const SignalSample sample = flight().at(base::Time{point.time_ns}).value();
        EXPECT_EQ(point.latitude_rad, sample[flight::Signal::latitude]);
        EXPECT_EQ(point.height_m, static_cast<float>(sample[flight::Signal::true_altitude]));
        EXPECT_EQ(attribute("ground_speed").values[n], static_cast<float>(sample[flight::Signal::ground_speed]));
    }
}

/// The way flown from the states 10 ms apart, by their speeds.
TEST_F(PlannedFlight, IsLessSureByTheWayFlownAndSureOfTheStrip) {
    const std::vector<float>&position = attribute("position_accuracy").values, &height = attribute("height_accuracy").values;
    const LandingStrip& strip = shipped().strip;
    double flown_m = 0, widest_m = 0;
    std::size_t state = 0;
    for (std::size_t n = 0; n < position.size(); ++n) {
        const auto last =
            static_cast<std::size_t>(std::llround(1e-7 * static_cast<double>(layer().points[n].time_ns - flight().begin().ns)));
        for (; state < last; ++state)
            flown_m += kScenarioStep_s * std::hypot(flight().states()[state].north_mps, flight().states()[state].east_mps);
        const double away_m = earth::surface_distance_m({strip.latitude_rad, strip.longitude_rad, {}},
                                                        {layer().points[n].latitude_rad, layer().points[n].longitude_rad, {}});
        ASSERT_NEAR(static_cast<double>(position[n]), 20 + std::min(0.01 * flown_m, 0.03 * away_m), 1) << n;
        ASSERT_NEAR(static_cast<double>(height[n]), 10 + std::min(0.0025 * flown_m, 0.01 * away_m), 0.3) << n;
        widest_m = std::max(widest_m, static_cast<double>(position[n]));
    }
    EXPECT_EQ(position.front(), 20);
    EXPECT_GT(widest_m, 80);
    EXPECT_LT(position.back(), 50) << "it ends upon the strip";
}

TEST_F(PlannedFlight, StatesHowSureHeightsAndSpeedsAre) {
    for (const char* name : {"height", "ground_speed", "vertical_speed"})
        for (const scene::Uncertainty uncertainty : attribute(name).uncertainties) ASSERT_TRUE(uncertainty.is_known());
    EXPECT_LT(attribute("height").uncertainties.front().level(), attribute("height").uncertainties[60].level());
}

}  // namespace
}  // namespace tedavis::host_sim::test_planned_flight
