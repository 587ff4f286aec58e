#include "render_core/raytrace/space/ground_space.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/GeodesicExact.hpp>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::raytrace::test_ground_space {
namespace {

test_support::TdbSpec spec_at(double west_deg, double north_deg) {
    test_support::TdbSpec spec;
    spec.west_deg = west_deg;
    spec.north_deg = north_deg;
    spec.columns = spec.rows = 65;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 300.0 + 7 * i + 3 * j; };
    spec.measured = false;
    return spec;
}

TEST(GroundSpace, HasPostsAtWholeNumbers) {
    const test_support::WrittenTdb tdb(spec_at(9, 47));
    const GroundSpace space(tdb.database(), {5, 11, 44, 40}, 0.25);
    for (const std::uint32_t i : {5u, 20u, 44u})
        for (const std::uint32_t j : {11u, 33u, 40u}) {
            const glm::dvec3 place = space.place(tdb.position(i, j));
            EXPECT_NEAR(place.x, i - 5.0, 1e-7);
            EXPECT_NEAR(place.y, j - 11.0, 1e-7);
            EXPECT_NEAR(place.z, tdb.height_m(i, j) / 0.25, 1e-4);
            EXPECT_LT(glm::length(space.position(place) - tdb.position(i, j)), 1e-5);
        }
}

TEST(GroundSpace, GoesAcrossTheAntimeridian) {
    const test_support::WrittenTdb tdb(spec_at(180 - 30 / 1200.0, -20));
    const GroundSpace space(tdb.database(), {0, 0, 64, 64}, 1);
    for (std::uint32_t i = 0; i < 65; i += 8) EXPECT_NEAR(space.place(tdb.position(i, 9)).x, i, 1e-7);
    EXPECT_NEAR(space.place(space.position({-3, -2, 5000})).x, -3, 1e-7);
}

TEST(GroundSpace, KnowsHowFarPostsAreApart) {
    const test_support::WrittenTdb tdb(spec_at(9, 62));
    const GroundSpace space(tdb.database(), {0, 0, 64, 64}, 1);
    const terrain::Lattice& lattice = tdb.lattice();
    const GeographicLib::GeodesicExact earth(GeographicLib::Constants::WGS84_a(), GeographicLib::Constants::WGS84_f());
    const double latitude = base::degrees(lattice.latitude_rad(30)), longitude = base::degrees(lattice.longitude_rad(30));
    double across = 0, along = 0;
    earth.Inverse(latitude, longitude, latitude, base::degrees(lattice.longitude_rad(31)), across);
    earth.Inverse(latitude, longitude, base::degrees(lattice.latitude_rad(31)), longitude, along);
    EXPECT_NEAR(space.column_m(30), across, 1e-4);
    EXPECT_NEAR(space.row_m(30.5), along, 1e-4);
}

TEST(GroundSpace, RefusesWindowsThatItHasNoPlacesFor) {
    const test_support::WrittenTdb tdb(spec_at(9, 47));
    EXPECT_TRUE(GroundSpace::fits(tdb.lattice(), {0, 0, 64, 64}));
    EXPECT_FALSE(GroundSpace::fits(tdb.lattice(), {1, 0, 65, 64}));
    EXPECT_FALSE(GroundSpace::fits(tdb.lattice(), {0, 7, 64, 7}));
    test_support::TdbSpec spec = test_support::whole_earth(129, 65);
    spec.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
    const test_support::WrittenTdb earth(spec);
    EXPECT_FALSE(GroundSpace::fits(earth.lattice(), {0, 1, 10, 10}));
}

}  // namespace
}  // namespace tedavis::raytrace::test_ground_space
