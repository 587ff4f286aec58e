#include "host_sim/terrain_builder/terrain_sources.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_terrain_sources {
namespace {

using test_support::make_raster;
using test_support::posts_of;

Raster flat(std::uint32_t columns, std::uint32_t rows, double west, double north, double step) {
    return make_raster(
        columns, rows, [](auto, auto) { return 5.0f; }, west, north, step);
}

TEST(TerrainPlan, ARasterAloneIsBothPlans) {
    const Raster raster = flat(70, 50, 9, 47, 0.01);
    const TerrainPlan plan(posts_of(raster), {});
    EXPECT_EQ(plan.coverage.base_level(), 0u);
    EXPECT_EQ(std::memcmp(&plan.coarse.header, &plan.fine.header, sizeof plan.fine.header), 0);
    EXPECT_TRUE(plan.insets.empty());
}

TEST(TerrainPlan, FinePostsAreAsDenseAsTheFinestInset) {
    const Raster raster = flat(70, 50, 9, 47, 0.01);
    for (const auto& [density, levels] :
         {std::pair{2.0, 1u}, {2.1, 1u}, {3.0, 2u}, {4.0, 2u}, {8.1, 3u}, {30.0, 5u}, {100.0, 5u}}) {
        const Raster inset = flat(40, 40, 9.2, 46.8, 0.01 / density), other = flat(10, 10, 9.4, 46.9, 0.006);
        const TerrainPlan plan(TerrainSources(posts_of(raster), {posts_of(inset), posts_of(other)}), {});
        EXPECT_EQ(plan.coverage.base_level(), levels) << density;
        EXPECT_EQ(plan.fine.header.columns, 69u * (1u << levels) + 1);
        EXPECT_EQ(plan.fine.levels(), plan.coarse.levels() + levels);
        for (std::uint32_t i = 0; i < 70; ++i)
            EXPECT_EQ(plan.fine.lattice.longitude_rad(i << levels), plan.coarse.lattice.longitude_rad(i)) << "to the last bit";
        for (std::uint32_t level = 0; level < plan.coarse.levels(); ++level)
            EXPECT_EQ(plan.fine.quantum_m(level + levels), plan.coarse.quantum_m(level));
        EXPECT_EQ(plan.insets.size(), 2u);
    }
}

TEST(TerrainPlan, RefusesInsetsThatCannotBe) {
    const Raster raster = flat(70, 50, 9, 47, 0.01), far = flat(40, 40, 30, 46.8, 0.001), near = flat(40, 40, 9.2, 46.8, 0.001);
    test_support::expect_user_error([&] { TerrainPlan(TerrainSources(posts_of(raster), {posts_of(far)}), {}); }, "lies outside");
    const Raster earth = test_support::make_earth_raster(5);
    test_support::expect_user_error([&] { TerrainPlan(TerrainSources(posts_of(earth), {posts_of(near)}), {}); }, "--bounds");
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_sources
