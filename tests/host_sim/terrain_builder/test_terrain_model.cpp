#include "host_sim/terrain_builder/terrain_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::kChunkCells;
using terrain::PostClass;

TEST(TerrainModel, TheLatticeIsWholeChunksOfTheTopLevel) {
    for (const auto& [columns, rows] : {std::pair{2u, 2u}, {33u, 33u}, {34u, 20u}, {200u, 70u}, {129u, 257u}}) {
        const TerrainModel model = make_model(test_support::make_rough_raster(columns, rows), {});
        const std::int64_t side = std::int64_t{kChunkCells} << (model.lattice.levels - 1);
        EXPECT_EQ((model.lattice.columns - 1) % side, 0);
        EXPECT_EQ((model.lattice.rows - 1) % side, 0);
        EXPECT_GE(model.lattice.columns, columns);
        EXPECT_LT(model.lattice.columns - side, columns) << "and no more than needed";
        EXPECT_EQ(model.levels.size(), static_cast<std::size_t>(model.lattice.columns * model.lattice.rows));
    }
}

TEST(TerrainModel, PostsBeyondTheRasterAreOutsideAndRepeatItsBorder) {
    const TerrainModel model = make_model(test_support::make_rough_raster(40, 35), {});
    const Lattice& lattice = model.lattice;
    EXPECT_EQ(lattice.post_class[lattice.at(39, 34)], PostClass::land);
    EXPECT_EQ(lattice.post_class[lattice.at(40, 10)], PostClass::outside);
    EXPECT_EQ(lattice.post_class[lattice.at(10, 35)], PostClass::outside);
    EXPECT_EQ(lattice.surface_m[lattice.at(60, 10)], lattice.surface_m[lattice.at(39, 10)]);
    EXPECT_EQ(lattice.surface_m[lattice.at(60, 60)], lattice.surface_m[lattice.at(39, 34)]);
}

// Oracle: the world grid itself; between its nodes both are bilinear.
TEST(TerrainModel, TheSurfaceIsTheHeightPlusTheGeoid) {
    const Raster raster = test_support::make_raster(300, 200, [](std::uint32_t, std::uint32_t) { return 1000.0f; });
    const TerrainModel model = make_model(raster, {});
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    for (const std::int64_t j : {0, 77, 199}) {
        for (const std::int64_t i : {0, 123, 299}) {
            const double undulation =
                geoid.undulation(base::radians(post_latitude_deg(raster, j)), base::radians(post_longitude_deg(raster, i))).m;
            EXPECT_NEAR(model.lattice.surface_m[model.lattice.at(i, j)], 1000 + undulation, 1e-3);
        }
    }
}

TEST(TerrainModel, TolerancesGrowFromExactAndLevelsCoverTheRaster) {
    const TerrainModel model = make_model(test_support::make_rough_raster(257, 257), {});
    EXPECT_LT(model.tolerance_m[0], 1e-3f);
    for (std::uint32_t level = 1; level < model.lattice.levels; ++level)
        EXPECT_GE(model.tolerance_m[level], model.tolerance_m[level - 1]);
    EXPECT_EQ(model.lattice.levels, 4u) << "256 cells are 8 chunks across: four levels down to one chunk";
}

TEST(TerrainModel, CellsAreNeverTakenForSmallerThanTheyAre) {
    Raster raster = test_support::make_raster(
        40, 40, [](std::uint32_t, std::uint32_t) { return 0.0f; }, 10, 0.02);
    EXPECT_GE(make_model(raster, {}).lattice.cell_m, base::radians(raster.step_lon_deg) * 6378137) << "across the equator";
    raster.north_deg = 60;
    EXPECT_GE(make_model(raster, {}).lattice.cell_m, base::radians(raster.step_lat_deg) * 6366000) << "north-south at 60 degrees";
}

TEST(TerrainModel, LatitudesStopAtThePole) {
    Raster raster;
    raster.north_deg = -89.9;
    raster.step_lat_deg = 0.1;
    raster.west_deg = 170;
    raster.step_lon_deg = 0.5;
    EXPECT_EQ(post_latitude_deg(raster, 5), -90);
    EXPECT_EQ(post_longitude_deg(raster, 30), 185);
}

TEST(TerrainModel, ScatteredVoidsCostLevelsNotTheBuild) {
    Raster raster = test_support::make_rough_raster(257, 257);
    for (std::uint32_t j = 0; j < 257; j += 3) {
        for (std::uint32_t i = 0; i < 257; i += 3) {
            raster.height_m[raster.at(i, j)] = NAN;
            raster.post_class[raster.at(i, j)] = PostClass::void_;
            ++raster.void_posts;
        }
    }
    const TerrainModel model = make_model(raster, {});
    EXPECT_LT(model.lattice.levels, 4u);
    EXPECT_GE(model.lattice.levels, 1u);
}

}  // namespace
}  // namespace tedavis::host_sim
