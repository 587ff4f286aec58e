#include "host_sim/terrain_builder/surface_heights.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_surface_heights {
namespace {

TEST(SurfaceHeights, AreHeightsAndUndulation) {
    const test_support::BuildGround ground(test_support::make_rough_raster(70, 60));
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const LatticeWindow all = ground.all(), part = ground.window(13, 20, 9, 4);
    for (std::uint32_t j = 0; j < 60; ++j)
        for (std::uint32_t i = 0; i < 70; ++i) {
            const double undulation =
                geoid.undulation(ground.plan.lattice.latitude_rad(j), ground.plan.lattice.longitude_rad(i)).m;
            ASSERT_NEAR(all.surface_m[all.at(i, j)], all.height_m[all.at(i, j)] + undulation, 1e-3);
        }
    for (std::int64_t j = 20; j < 24; ++j)
        for (std::int64_t i = 13; i < 22; ++i) ASSERT_EQ(part.surface_m[part.at(i, j)], all.surface_m[all.at(i, j)]);
    EXPECT_EQ(all.surface_m[all.at(-1, 5)], 0) << "outside";
}

TEST(SurfaceHeights, GoOnRoundTheEarth) {
    const test_support::BuildGround ground(test_support::make_earth_raster(5));
    const LatticeWindow w = ground.window(-3, 10, 80, 1);
    EXPECT_EQ(w.surface_m[w.at(-1, 10)], w.surface_m[w.at(71, 10)]);
    EXPECT_EQ(w.surface_m[w.at(72, 10)], w.surface_m[w.at(0, 10)]);
}

}  // namespace
}  // namespace tedavis::host_sim::test_surface_heights
