// Oracle: GeographicLib::Geodesic, independent code that states 15 nm.
#include "host_sim/accuracy/knobs/distance_knob.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>

#include "render_core/base/units.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::host_sim::test_distance_knob {
namespace {

double geodesic_m(const earth::Geodetic& from, const earth::Geodetic& to) {
    double distance_m = 0;
    GeographicLib::Geodesic::WGS84().Inverse(base::degrees(from.latitude_rad), base::degrees(from.longitude_rad),
                                             base::degrees(to.latitude_rad), base::degrees(to.longitude_rad), distance_m);
    return distance_m;
}

TEST(DistanceKnob, TheReferenceIsWithinItsBound) {
    const test_support::MadeKnobGround made;
    const double bound = make_surface_distance_knob(made.quick())->facts().reference.error_bound();
    test_support::Dice dice(1);
    for (int n = 0; n < 20'000; ++n) {
        const earth::Geodetic from{base::radians(dice.between(-89, 89)), dice.between(-3.14, 3.14), {}};
        const double reach = std::pow(10.0, dice.between(-6, -1.2));
        const earth::Geodetic to{std::clamp(from.latitude_rad + reach * dice.between(-1, 1), -1.56, 1.56),
                                 from.longitude_rad + reach * dice.between(-1, 1),
                                 {}};
        ASSERT_NEAR(distance_by_vincenty_m(from, to), geodesic_m(from, to), bound) << from.latitude_rad << ' ' << to.latitude_rad;
    }
    const earth::Geodetic here{0.8, 0.2, {}}, on_equator{0, 0.1, {}}, farther{0, 0.15, {}};
    EXPECT_EQ(distance_by_vincenty_m(here, here), 0);
    EXPECT_NEAR(distance_by_vincenty_m(on_equator, farther), geodesic_m(on_equator, farther), bound) << "along the equator";
    const earth::Geodetic west{0.5, 3.14, {}}, east{0.5, -3.14, {}};
    EXPECT_NEAR(distance_by_vincenty_m(west, east), geodesic_m(west, east), bound) << "across the antimeridian";
}

TEST(DistanceKnob, TheProductKeepsItsClaimWhereTheHaversineDoesNot) {
    const test_support::MadeKnobGround made;
    const auto knob = make_surface_distance_knob(made.quick());
    ASSERT_TRUE(knob->facts().only_level.has_value());
    constexpr double kFarthest_m = 400'000, kClaim = 1e-6;  // wgs84.hpp
    const ErrorDistribution ours = test_support::errors_of(*knob, 0), plane = test_support::errors_of(*knob, 1),
                            haversine = test_support::errors_of(*knob, 2), vincenty = test_support::errors_of(*knob, 3);
    EXPECT_LT(ours.max, kClaim * kFarthest_m);
    EXPECT_GT(ours.max, 10 * knob->facts().reference.error_bound()) << "the reference can tell";
    EXPECT_GT(haversine.max, 1000 * ours.max) << "control";
    EXPECT_GT(plane.max, 10 * ours.max) << "control";
    EXPECT_LT(vincenty.max, knob->facts().reference.error_bound());
}

}  // namespace
}  // namespace tedavis::host_sim::test_distance_knob
