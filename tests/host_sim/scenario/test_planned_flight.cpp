#include "host_sim/scenario/planned_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/input_file.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

class PlannedFlight : public ::testing::Test {
protected:
    static const ScenarioFlight& flight() {
        static const GeoidEgm96 geoid = GeoidEgm96::installed();
        static const ScenarioFlight flown(
            parse_scenario(read_file(TEDAVIS_SOURCE_DIR "/configs/scenarios/default.toml"), "default.toml"), 1, geoid);
        return flown;
    }
    static const LayerDraft& layer() {
        static const LayerDraft made = make_flight_layer(flight());
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
TEST_F(PlannedFlight, IsLessSureByTheWayFlown) {
    double flown_m = 0;
    for (const ScenarioFlight::State& state : flight().states())
        flown_m += kScenarioStep_s * std::hypot(state.north_mps, state.east_mps);
    const std::vector<float>& position = attribute("position_accuracy").values;
    EXPECT_EQ(position.front(), 20);
    EXPECT_NEAR(static_cast<double>(position.back()), 20 + 0.01 * flown_m, 1);
    EXPECT_NEAR(static_cast<double>(attribute("height_accuracy").values.back()), 10 + 0.0025 * flown_m, 0.3);
    for (std::size_t n = 1; n < position.size(); ++n) EXPECT_GE(position[n], position[n - 1]);
    EXPECT_GT(flown_m, 20'000);
}

TEST_F(PlannedFlight, StatesHowSureHeightsAndSpeedsAre) {
    for (const char* name : {"height", "ground_speed", "vertical_speed"})
        for (const scene::Uncertainty uncertainty : attribute(name).uncertainties) ASSERT_TRUE(uncertainty.is_known());
    EXPECT_LT(attribute("height").uncertainties.front().level(), attribute("height").uncertainties.back().level());
}

}  // namespace
}  // namespace tedavis::host_sim
