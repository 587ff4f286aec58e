#include "render_core/display/planner/visible_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::display::test_visible_bounds {
namespace {

TEST(VisibleBounds, HazeGrowsToTheFarthestGround) {
    EXPECT_NEAR(haze_bound(1e-5, 30'000), 1 - std::exp(-0.3), 1e-12);
    EXPECT_EQ(haze_bound(1e-5, std::numeric_limits<double>::infinity()), 1);
    EXPECT_EQ(haze_bound(1e-5, 0), 0);
}

TEST(VisibleBounds, AirGrowsToTheFarthestGround) {
    const design::AirSettings air;
    EXPECT_GT(air_bound(air, 30'000), air_bound(air, 3'000));
    EXPECT_EQ(air_bound(air, 0), 0);
}

TEST(VisibleBounds, BlurIsWidestAtTheNearestOrFarthestGround) {
    const SeenSpan seen{1000, 30'000};
    EXPECT_EQ(blur_bound({true, 500, 40'000, 6}, seen), 0) << "all of it is in focus";
    EXPECT_NEAR(blur_bound({true, 500, 10'000, 6}, seen), 6 * (1 - 10'000.0 / 30'000), 1e-12);
    EXPECT_EQ(blur_bound({true, 3000, 40'000, 6}, seen), 6) << "nearer than half of the focus the blur grows no more";
    EXPECT_EQ(blur_bound({true, 0, 1000, 6}, {}), 6);
}

constexpr std::uint32_t kWidth = 200, kHeight = 150;

/// Straight down from 2 km: no ground is farther than some 3 km.
std::vector<std::uint8_t> seen_from_above(double haze_distance_m, bool is_forced, EffectState& haze) {
    test_support::MemoryBytes bytes(test_support::hills().image);
    design::DesignSettings design = test_support::shipped_design("default");
    design.sky.haze_distance_m = haze_distance_m;
    design.sky.haze = {255, 255, 255};
    test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &bytes, design);
    headless.display().planner().force_effects(is_forced);
    const flight::AircraftState aircraft = test_support::aircraft_over_hills(3000);
    const earth::Geodetic& place = aircraft.own_ship.position;
    const glm::dmat3 body = earth::body_axes(place.latitude_rad, place.longitude_rad, 0, base::radians(-85), 0);
    headless.display().planner().set_free_view(test_support::free_view(earth::to_ecef(place), body, kWidth, kHeight, 50));
    std::vector<std::uint8_t> rgba = test_support::settled_pixels(headless, aircraft, test_support::kHillsNow);
    EXPECT_GT(headless.display().record().terrain.triangles, 100u);
    haze = EffectState::replaced;
    for (const EffectRecord& effect : headless.display().record().effects)
        if (effect.name.view() == "haze") haze = effect.state;
    return rgba;
}

int largest_step(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int largest = 0;
    for (std::size_t n = 0; n < a.size(); ++n) largest = std::max(largest, std::abs(int{a[n]} - int{b[n]}));
    return largest;
}

TEST(EffectPictures, HazeThatIsLeftOutIsNotMissed) {
    EffectState haze{};
    const auto planned = seen_from_above(9e5, false, haze);
    EXPECT_EQ(haze, EffectState::skipped);
    const auto forced = seen_from_above(9e5, true, haze);
    EXPECT_EQ(haze, EffectState::run);
    EXPECT_LE(largest_step(planned, forced), 1);
    const auto thick = seen_from_above(4e4, false, haze);
    EXPECT_EQ(haze, EffectState::run) << "control";
    EXPECT_GT(largest_step(planned, thick), 5) << "control: it would be missed";
}

}  // namespace
}  // namespace tedavis::display::test_visible_bounds
