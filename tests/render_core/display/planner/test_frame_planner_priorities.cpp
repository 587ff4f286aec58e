// What weights and hazards make of a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "render_core/design/weighted_design.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_frame_planner_priorities {
namespace {

using test_support::HeadlessDisplay;

constexpr std::uint32_t kWidth = 320, kHeight = 240;

design::DesignSettings design_of(double terrain) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.name = "weighed";
    design.symbology.legend = false;
    design.warning_colors = false;
    design.terrain.style.sketch.silhouettes = 0.7;
    design.priority.is_stated = true;
    design.priority.weights.of[design::kTerrainAspect] = terrain;
    static_cast<void>(design.priority.shading.knots.try_push_back({0.3, 0}));
    static_cast<void>(design.priority.shading.knots.try_push_back({0.8, 1}));
    return design;
}

std::vector<std::uint8_t> picture(HeadlessDisplay& display, const flight::AircraftState& state) {
    return test_support::settled_pixels(display, state, test_support::kHillsNow, {});
}

std::vector<std::uint8_t> alone(const design::DesignSettings& design, const flight::AircraftState& state, const char* device) {
    test_support::MemoryBytes bytes{test_support::hills().image};
    HeadlessDisplay display("egl", device, kWidth, kHeight, &bytes, design);
    return picture(display, state);
}

int greatest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(int{a[n]} - int{b[n]}));
    return most;
}

double weight_of(HeadlessDisplay& headless, std::size_t aspect) { return headless.display().record().weights[aspect].weight; }

TEST(DisplayWeights, APictureIsThatOfTheWeighedDesign) {
    const flight::AircraftState state = test_support::aircraft_over_hills(3000);
    for (const char* device : {"es3-mid", "es2-small"}) {
        design::DesignSettings weighed = design_of(0.55);
        design::apply_priorities(weighed.priority.weights, weighed);
        weighed.priority.is_stated = false;
        const auto expected = alone(weighed, state, device), shown = alone(design_of(0.55), state, device);
        EXPECT_EQ(shown, expected) << device;
        EXPECT_GT(greatest_difference(shown, alone(design_of(1), state, device)), 10) << "control";
    }
}

/// The same place, flown level and down towards the ground.
TEST(DisplayWeights, TerrainOnTheWayComesForward) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        flight::AircraftState level = test_support::aircraft_over_hills(3000), down = level;
        down.own_ship.velocity_up_mps = -80;
        test_support::MemoryBytes bytes{test_support::hills().image};
        std::vector<std::uint8_t> calm, warned, again;
        {
            HeadlessDisplay headless("egl", device, kWidth, kHeight, &bytes, design_of(0.2));
            calm = picture(headless, level);
            EXPECT_EQ(weight_of(headless, design::kTerrainAspect), 0.2);
            warned = picture(headless, down);
            EXPECT_EQ(weight_of(headless, design::kTerrainAspect), 1);
            EXPECT_EQ(headless.display().record().weights[0].stated, 0.2);
            EXPECT_EQ(headless.display().record().terrain_aspect.detail, 1);
            again = picture(headless, level);
            EXPECT_EQ(headless.display().gl().denied().total, 0u);
        }
        EXPECT_EQ(calm, again) << device;
        EXPECT_LE(greatest_difference(calm, alone(design_of(0.2), level, device)), 0);
        EXPECT_LE(greatest_difference(warned, alone(design_of(1), down, device)), 1) << "as if it had been first";
        EXPECT_GT(greatest_difference(warned, calm), 20) << "control";
    }
}

TEST(DisplayWeights, WithoutAPlaceNothingIsOnTheWay) {
    flight::AircraftState lost = test_support::aircraft_over_hills(3000);
    lost.own_ship.velocity_up_mps = -80;
    lost.own_ship.state = base::SignalState::lost;
    test_support::MemoryBytes bytes{test_support::hills().image};
    HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes, design_of(0.2));
    settle(headless.display(), {lost, {}, test_support::kHillsNow});
    static_cast<void>(test_support::drawn_pixels(headless));
    EXPECT_EQ(weight_of(headless, design::kTerrainAspect), 0.2);
    EXPECT_EQ(headless.display().record().terrain_aspect.detail, 0) << "it is not shown at all";
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_priorities
