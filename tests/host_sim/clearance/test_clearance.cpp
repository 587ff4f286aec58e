#include "host_sim/clearance/clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_clearance {
namespace {

using flight::Signal;

const base::Time kNow{5'000'000'000};

/// A valley that runs north, with a wall in the east from column 60 on.
Raster valley() {
    return test_support::make_raster(97, 97, [](std::uint32_t i, auto) { return i < 60 ? 500.0f : 2500.0f; });
}

struct OverValley {
    explicit OverValley(double le90_m = 16) : built(valley(), options(le90_m)), meter(built.database) {}
    static BuildOptions options(double le90_m) {
        BuildOptions options;
        options.le90_m = le90_m;
        return options;
    }
    /// Northbound at 1500 m above mean sea level, `columns` of 63 m west of the wall's foot.
    [[nodiscard]] flight::AircraftState state(double columns) const {
        flight::AircraftState state;
        flight::OwnShipEstimate& own = state.own_ship;
        own.position.latitude_rad = built.lattice().latitude_rad(48);
        own.position.longitude_rad = base::radians(9.6 + (59 - columns) / 1200);
        own.position.height.m = 1500 + built.database.undulation(own.position.latitude_rad, own.position.longitude_rad).m;
        own.velocity_north_mps = 60;
        own.state = base::SignalState::valid;
        own.height_is_geometric = true;
        state[Signal::vertical_accuracy] = {20.0, kNow};
        state[Signal::horizontal_accuracy] = {10.0, kNow};
        return state;
    }
    test_support::BuiltDatabase built;
    ClearanceMeter meter;
};

TEST(Clearance, ToldAheadAsideAndBelow) {
    OverValley over;
    const auto clearance = over.meter.measure(over.state(5), kNow, 0);
    ASSERT_TRUE(clearance);
    EXPECT_NEAR(clearance->height_above_terrain_m, 1000, 1e-6);
    EXPECT_LT(clearance->nearest.distance_m, 400);
    EXPECT_NEAR(base::degrees(clearance->nearest_off_track_rad), 90, 2);
    EXPECT_TRUE(clearance->nearest_is_whole);
    ASSERT_TRUE(clearance->level.right);
    EXPECT_NEAR(clearance->level.right->distance_m, 5.5 * 63.3, 8) << "half way up the column of the wall";
    EXPECT_FALSE(clearance->level.left);
    ASSERT_TRUE(clearance->level.ahead) << "the sector ahead reaches the wall at 45 degrees";
    EXPECT_NEAR(clearance->level.ahead->distance_m, 5.5 * 63.3 * std::sqrt(2.0), 10);
    EXPECT_FALSE(clearance->level.is_whole) << "the raster ends within 10 km";
}

TEST(Clearance, SidesAreThoseOfTheTrackAndOfTheHeadingOnlyWhereItStands) {
    OverValley over;
    flight::AircraftState state = over.state(5);
    state.own_ship.velocity_north_mps = -60;
    auto clearance = over.meter.measure(state, kNow, 0);
    ASSERT_TRUE(clearance && clearance->level.left);
    EXPECT_FALSE(clearance->level.right) << "southbound, whatever the heading";
    EXPECT_NEAR(base::degrees(clearance->nearest_off_track_rad), -90, 2);
    state.own_ship.velocity_north_mps = 0;
    clearance = over.meter.measure(state, kNow, 0);
    ASSERT_TRUE(clearance);
    EXPECT_TRUE(clearance->level.right);
}

TEST(Clearance, UncertaintyIsTheRootOfTheSumOfSquaresAt95Percent) {
    OverValley over;
    const auto uncertainty = over.meter.uncertainty_of(over.state(5), kNow);
    ASSERT_TRUE(uncertainty.terrain_m);
    EXPECT_NEAR(*uncertainty.terrain_m, 16 * 1.96 / 1.645, 0.01);
    EXPECT_NEAR(uncertainty.height_above_terrain_m().value(), std::sqrt(400 + 19.0635 * 19.0635), 0.01);
    EXPECT_EQ(uncertainty.position_m, 10.0);
}

TEST(Clearance, WhatIsNotStatedIsNotInvented) {
    OverValley over, unknown_terrain(0);
    flight::AircraftState state = over.state(5);
    EXPECT_FALSE(unknown_terrain.meter.uncertainty_of(state, kNow).height_above_terrain_m());
    EXPECT_FALSE(over.meter.uncertainty_of(state, kNow + base::Duration::seconds(60)).height_m) << "lost by then";
    state.own_ship.height_is_geometric = false;
    EXPECT_FALSE(over.meter.uncertainty_of(state, kNow).height_m) << "figures of merit are of GNSS";
    state.own_ship.position.height.m = 1500;
    EXPECT_NEAR(over.meter.measure(state, kNow, 0)->height_above_terrain_m, 1000, 1e-6) << "above mean sea level";
}

TEST(Clearance, NothingWhereTheGroundOrThePositionIsNotKnown) {
    OverValley over;
    flight::AircraftState state = over.state(5);
    state.own_ship.state = base::SignalState::stale;
    EXPECT_FALSE(over.meter.measure(state, kNow, 0));
    state = over.state(5);
    state.own_ship.position.latitude_rad += 0.1;
    EXPECT_FALSE(over.meter.measure(state, kNow, 0)) << "outside";
    const test_support::BuiltDatabase with_void(test_support::make_raster(
        97, 97, [](std::uint32_t i, std::uint32_t j) { return i > 50 && i < 58 && j == 48 ? std::nanf("") : 500.0f; }));
    EXPECT_FALSE(ClearanceMeter(with_void.database).measure(over.state(5), kNow, 0)) << "over a void";
    const auto beside = ClearanceMeter(with_void.database).measure(over.state(15), kNow, 0);
    ASSERT_TRUE(beside);
    EXPECT_FALSE(beside->nearest_is_whole) << "a void lies nearer than the ground below";
}

}  // namespace
}  // namespace tedavis::host_sim::test_clearance
