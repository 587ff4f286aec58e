#include "host_sim/terrain_builder/post_places.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_post_places {
namespace {

using test_support::BuildGround;

TEST(PostPlaces, AreTheLatticesToTheLastBit) {
    for (const Raster& raster : {test_support::make_rough_raster(70, 60), test_support::make_earth_raster(5)}) {
        const BuildGround ground(raster);
        const terrain::Lattice& lattice = ground.plan.lattice;
        const PostPlaces places(lattice, 0, 0, lattice.columns(), lattice.rows());
        for (std::uint32_t j = 0; j < lattice.rows(); ++j)
            for (std::uint32_t i = 0; i < lattice.columns(); ++i)
                ASSERT_EQ(places.at(i, j, 123.25 + j), lattice.position(i, j, 123.25 + j)) << i << " " << j;
    }
}

TEST(PostPlaces, GoOnRoundTheEarth) {
    const BuildGround ground(test_support::make_earth_raster(5));
    const PostPlaces places(ground.plan.lattice, -2, 4, 80, 3);
    EXPECT_EQ(places.at(-1, 5, 7), places.at(71, 5, 7));
    EXPECT_EQ(places.at(72, 5, 7), places.at(0, 5, 7));
    EXPECT_EQ(places.at(73, 5, 7), places.at(1, 5, 7));
}

TEST(PostPlaces, NormalsStandOnTheSlope) {
    // Rises 0.3 m a metre to the east and 0.2 to the north, in local metres of the raster's middle.
    const double lat = 46.9, lon = 9.8, step = 1.0 / 3600;
    const GeographicLib::LocalCartesian local(lat, lon, 0);
    const Raster raster = test_support::make_raster(
        21, 21,
        [&](std::uint32_t i, std::uint32_t j) {
            double x = 0, y = 0, z = 0;
            local.Forward(lat + (10.0 - j) * step, lon + (i - 10.0) * step, 0, x, y, z);
            return static_cast<float>(1000 + 0.3 * x + 0.2 * y);
        },
        lon - 10 * step, lat + 10 * step, step);
    const BuildGround ground(raster);
    const LatticeWindow window = ground.all();
    const PostPlaces places(ground.plan.lattice, window.i0, window.j0, window.columns, window.rows);
    const glm::dvec3 normal = places.normal(window, 10, 10);
    const glm::dmat3 frame = earth::north_east_down(base::radians(lat), base::radians(lon));
    const glm::dvec3 expected = glm::normalize(frame * glm::dvec3(-0.2, -0.3, -1));
    EXPECT_NEAR(glm::dot(normal, expected), 1, 1e-7);
    EXPECT_NEAR(glm::dot(places.normal(window, 0, 0), expected), 1, 1e-6) << "one-sided at the corner";
    EXPECT_LT(glm::dot(places.up(10, 10), expected), 0.95);
}

TEST(PostPlaces, NormalsWithoutNeighboursAreUpright) {
    Raster raster = test_support::make_rough_raster(40, 40);
    for (const std::uint32_t i : {19u, 21u}) raster.post_class[raster.at(i, 20)] = terrain::PostClass::void_;
    const BuildGround ground(raster);
    const LatticeWindow window = ground.all();
    const PostPlaces places(ground.plan.lattice, window.i0, window.j0, window.columns, window.rows);
    EXPECT_EQ(places.normal(window, 20, 20), places.up(20, 20)) << "voids on both sides";
    EXPECT_EQ(places.normal(window, 19, 20), places.up(19, 20)) << "void itself";
    EXPECT_NE(places.normal(window, 25, 20), places.up(25, 20));
    const BuildGround earth(test_support::make_earth_raster(5));
    const LatticeWindow all = earth.all();
    const PostPlaces round(earth.plan.lattice, all.i0, all.j0, all.columns, all.rows);
    EXPECT_EQ(round.normal(all, 3, 0), glm::dvec3(0, 0, 1));
    EXPECT_EQ(round.normal(all, 3, 37), glm::dvec3(0, 0, -1));
}

}  // namespace
}  // namespace tedavis::host_sim::test_post_places
