#include "host_sim/accuracy/knobs/air_knob.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>

#include "render_core/base/units.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_air_knob {
namespace {

double difference(const earth::AirLight& a, const earth::AirLight& b) {
    double most = 0;
    for (int band = 0; band < 3; ++band)
        most =
            std::max({most, std::abs(a.transmittance[band] - b.transmittance[band]),
                      std::abs(a.by_molecules[band] - b.by_molecules[band]), std::abs(a.by_aerosol[band] - b.by_aerosol[band])});
    return most;
}

TEST(AirKnob, TheReferenceIsWithinItsBound) {
    const test_support::MadeKnobGround made;
    const double bound = make_air_steps_knob(made.quick())->facts().reference.error_bound();
    for (const double visibility_m : {20'000.0, 120'000.0}) {
        const earth::Air air = earth::air_of_visibility(visibility_m);
        for (const double elevation_deg : {5.0, 60.0}) {
            const earth::SunThroughAir sun(air, base::radians(elevation_deg));
            for (const AirRay& ray : {AirRay{3000, -0.02, 120'000}, AirRay{12'000, -0.03, 380'000}, AirRay{60, 0.01, 5000}}) {
                const earth::AirLight exact = air_by_midpoints(air, sun, ray, 32768);
                EXPECT_LT(difference(air_by_midpoints(air, sun, ray, 8192), exact), bound);
                EXPECT_GT(difference(air_by_midpoints(air, sun, ray, 8), exact), bound) << "control";
            }
        }
    }
}

/// Where all heights are one: both ends of a short ray at the same height have the same air, and Beer's law is exact.
TEST(AirKnob, TheReferenceIsBeersLawWhereTheAirIsEven) {
    earth::Air air;
    air.molecules_height_m = air.aerosol_height_m = 1e12;
    const earth::SunThroughAir sun(air, base::radians(90));
    const earth::AirLight light = air_by_midpoints(air, sun, {1000, 0, 50'000}, 2000);
    for (int band = 0; band < 3; ++band) {
        const double per_m = air.molecules_per_m[band] + air.aerosol_per_m / earth::kAerosolAlbedo;
        EXPECT_NEAR(light.transmittance[band], std::exp(-per_m * 50'000), 1e-6);
        const double lit = sun.at(1000)[band] * (1 - std::exp(-per_m * 50'000)) / per_m;
        EXPECT_NEAR(light.by_aerosol[band] / (lit * air.aerosol_per_m), 1, 0.01) << "sunlight hardly changes with height";
    }
}

TEST(AirKnob, ErrorsFallWithTheSquareOfTheSteps) {
    const test_support::MadeKnobGround made;
    const auto knob = make_air_steps_knob(made.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, knob->facts().law->exponent, knob->facts().law->tolerance);
    EXPECT_GT(test_support::errors_of(*knob, 1).max, 0.1) << "control: one step is visibly wrong";
}

/// Its means are of the display's table: near those of a few steps, and no law's.
TEST(AirKnob, TheTableHasTheErrorOfItsColumnsAndTakesMemory) {
    const test_support::MadeKnobGround made;
    const auto knob = make_air_steps_knob(made.quick());
    EXPECT_EQ(knob->facts().levels[0].amount, 0) << "on no scale";
    const ErrorDistribution table = test_support::errors_of(*knob, 0);
    EXPECT_LT(table.mean, test_support::errors_of(*knob, 2).mean) << "two steps along the ray";
    EXPECT_GT(table.mean, test_support::errors_of(*knob, 6).mean) << "32 steps";
    EXPECT_EQ(knob->bytes(0), 64u * 64 * 3 * 8);
    EXPECT_GT(knob->build_ms(0), 0);
    EXPECT_EQ(knob->bytes(1), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_air_knob
