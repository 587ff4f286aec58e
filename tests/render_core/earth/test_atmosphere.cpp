#include "render_core/earth/atmosphere.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::earth::test_atmosphere {
namespace {

/// Columns of air by places in space and long doubles, without the ray's own formula.
struct Column {
    long double molecules_m = 0, aerosol_m = 0;
};
Column column_of(const Air& air, double eye_height_m, double sine, double length_m, int steps = 20'000) {
    const long double r = static_cast<long double>(kMeanRadius_m);
    const long double up = sine, level = std::sqrt(1 - up * up);
    Column column;
    for (int n = 0; n < steps; ++n) {
        const long double at = length_m * (n + 0.5L) / steps;
        const long double height = std::hypot(at * level, r + eye_height_m + at * up) - r;
        column.molecules_m += std::exp(-height / static_cast<long double>(air.molecules_height_m)) * length_m / steps;
        column.aerosol_m += std::exp(-height / static_cast<long double>(air.aerosol_height_m)) * length_m / steps;
    }
    return column;
}

AirLight seen(const Air& air, double height_m, double sine, double length_m, int steps = 64) {
    const SunThroughAir sun(air, base::radians(30));
    AirPath way(air, sun, height_m, sine);
    way.walk_to(length_m, steps);
    return way.light();
}

double relative(double value, double wanted) { return std::fabs(value - wanted) / wanted; }

TEST(Atmosphere, ExtinctionIsThatOfTheColumnOnARoundEarth) {
    const Air air = air_of_visibility(60'000);
    const struct {
        double height_m, sine, length_m;
    } rays[] = {{0, 0, 1},
                {0, 0, 1e-3},
                {3000, 0, 400'000},
                {3000, -0.02, 150'000},
                {12'000, -0.03, 390'000},
                {3000, 1e-9, 100'000},
                {500, 1, 50'000},
                {10'000, -1, 9'999},
                {0, 0.05, 1'000'000},
                {15'000, 0, 900'000}};
    double worst = 0;
    for (const auto& ray : rays) {
        const Column column = column_of(air, ray.height_m, ray.sine, ray.length_m);
        const AirLight light = seen(air, ray.height_m, ray.sine, ray.length_m);
        for (int band = 0; band < 3; ++band) {
            const auto depth =
                static_cast<double>(static_cast<long double>(air.molecules_per_m[band]) * column.molecules_m +
                                    static_cast<long double>(air.aerosol_per_m / kAerosolAlbedo) * column.aerosol_m);
            const double off = relative(-std::log(light.transmittance[band]), depth);
            EXPECT_LT(off, 1e-3) << ray.height_m << " m, sine " << ray.sine << ", " << ray.length_m << " m, band " << band;
            worst = std::fmax(worst, off);
        }
    }
    test_support::record_worst("A30", worst);
}

/// What a flat Earth would have: the check above sees the difference.
TEST(Atmosphere, AFlatEarthIsNotTheSame) {
    const Air air = air_of_visibility(60'000);
    const double flat = air.molecules_per_m.y * std::exp(-3000 / air.molecules_height_m) * 400'000 +
                        air.aerosol_per_m / kAerosolAlbedo * std::exp(-3000 / air.aerosol_height_m) * 400'000;
    const double off = relative(flat, -std::log(seen(air, 3000, 0, 400'000).transmittance.y));
    EXPECT_GT(off, 0.1);
    test_support::record_control("A30", off);
}

TEST(Atmosphere, AWayInPartsIsTheWholeWay) {
    const Air air;
    const SunThroughAir sun(air, base::radians(20));
    AirPath whole(air, sun, 2000, -0.004), parts(air, sun, 2000, -0.004);
    whole.walk_to(200'000, 64);
    for (const double length_m : {50'000.0, 100'000.0, 150'000.0, 200'000.0}) parts.walk_to(length_m, 16);
    EXPECT_LT(glm::distance(whole.light().transmittance, parts.light().transmittance), 1e-12);
    EXPECT_LT(glm::distance(whole.light().by_aerosol, parts.light().by_aerosol), 1e-12);
    AirPath nothing(air, sun, 2000, 0);
    nothing.walk_to(0, 4);
    EXPECT_EQ(nothing.light().transmittance, glm::dvec3(1, 1, 1));
    EXPECT_EQ(nothing.light().by_molecules, glm::dvec3(0, 0, 0));
}

/// No band at the height of the eye: nearly level rays have nearly the same air.
TEST(Atmosphere, LevelRaysHaveNoBand) {
    const Air air;
    double last = seen(air, 1500, -1e-3, 80'000).transmittance.z;
    for (int n = -99; n <= 100; ++n) {
        const double left = seen(air, 1500, n * 1e-5, 80'000).transmittance.z;
        EXPECT_GT(left, last) << "higher rays go through thinner air";
        EXPECT_LT(left - last, 0.001);
        last = left;
    }
}

TEST(Atmosphere, VisibilityIsWhereContrastIsTwoPercent) {
    for (const double visibility_m : {5'000.0, 40'000.0, 200'000.0}) {
        const AirLight light = seen(air_of_visibility(visibility_m), 0, 0, visibility_m, 512);
        // The ray leaves the sea behind: over 200 km it climbs by 3 km.
        EXPECT_NEAR(light.transmittance.y, 0.02, visibility_m > 100'000 ? 0.1 : 0.006);
    }
    EXPECT_EQ(air_of_visibility(1e6).aerosol_per_m, 0) << "limited by the molecules alone";
}

TEST(Atmosphere, LightIsNeitherMadeNorLost) {
    for (const double elevation_deg : {3.0, 45.0, 90.0}) {
        const Air air;
        const SunThroughAir sun(air, base::radians(elevation_deg));
        for (double height_m = -400; height_m < 99'000; height_m += 700) {
            const glm::dvec3 left = sun.at(height_m);
            EXPECT_GE(glm::min(left.x, left.z), 0);
            EXPECT_LE(glm::max(left.x, left.z), 1);
            EXPECT_GE(left.x, left.z) << "red goes farther";
        }
        AirPath out(air, sun, 0, 0.001);
        out.walk_out(512);
        EXPECT_LT(glm::length(out.light().by_molecules + out.light().by_aerosol), 3);
    }
    EXPECT_NEAR(SunThroughAir(Air{}, base::radians(90)).at(0).y, std::exp(-(13.5e-6 * 8000 + 5.7e-5 / kAerosolAlbedo * 1200)),
                1e-3)
        << "straight up the column is the scale height";
}

TEST(Atmosphere, PhasesScatterAllThatTheyTake) {
    constexpr int kSteps = 20'000;
    double molecules = 0, aerosol = 0;
    for (int n = 0; n < kSteps; ++n) {
        const double cosine = -1 + 2 * (n + 0.5) / kSteps;
        molecules += molecule_phase(cosine) * 2 / kSteps * 2 * base::kPi;
        aerosol += aerosol_phase(cosine) * 2 / kSteps * 2 * base::kPi;
    }
    EXPECT_NEAR(molecules, 1, 1e-6);
    EXPECT_NEAR(aerosol, 1, 1e-4);
    EXPECT_GT(aerosol_phase(1), 20 * aerosol_phase(0)) << "forward";
}

}  // namespace
}  // namespace tedavis::earth::test_atmosphere
