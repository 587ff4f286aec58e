#include "host_sim/terrain_builder/fractal_geotiff.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/terrain_builder/fractal_terrain.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_fractal_geotiff {
namespace {

// Oracle: the reader of any raster.
TEST(FractalGeotiff, HoldsItsPostsAtTheirPlace) {
    const test_support::TemporaryFolder folder;
    for (const FractalNumbers numbers : {FractalNumbers::float32, FractalNumbers::int16}) {
        for (const std::uint32_t posts : {3u, 100u, 300u, 513u}) {
            write_fractal_geotiff(folder.file("f.tif"), posts, 5, numbers);
            EXPECT_EQ(folder.entries(), 1u);
            const Raster raster = load_rasters({folder.file("f.tif")}, {});
            ASSERT_EQ(raster.columns, posts);
            ASSERT_EQ(raster.rows, posts);
            EXPECT_FALSE(raster.resampled);
            EXPECT_NEAR(raster.west_deg, kFractalWest_deg, 1e-12);
            EXPECT_NEAR(raster.north_deg, kFractalNorth_deg, 1e-12);
            EXPECT_NEAR(raster.step_lon_deg, kFractalStep_deg, 1e-15);
            std::vector<float> heights(std::size_t{posts} * posts);
            FractalTerrain(5).read(0, 0, posts, posts, heights);
            for (std::size_t n = 0; n < heights.size(); ++n)
                ASSERT_EQ(raster.height_m[n], numbers == FractalNumbers::int16 ? std::floor(heights[n] + 0.5f) : heights[n]) << n;
        }
    }
}

TEST(FractalGeotiff, IsTiled) {
    const test_support::TemporaryFolder folder;
    write_fractal_geotiff(folder.file("f.tif"), 600, 1, FractalNumbers::int16);
    const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(folder.file("f.tif").c_str()));
    int width = 0, height = 0;
    file->GetRasterBand(1)->GetBlockSize(&width, &height);
    EXPECT_EQ(width, 256);
    EXPECT_EQ(height, 256);
    EXPECT_EQ(file->GetRasterBand(1)->GetRasterDataType(), GDT_Int16);
}

TEST(FractalGeotiff, SaysHowFarItIsAndLeavesNothingWhenStopped) {
    const test_support::TemporaryFolder folder;
    std::uint64_t last = 0, total = 0;
    write_fractal_geotiff(folder.file("f.tif"), 600, 1, FractalNumbers::float32, [&](std::uint64_t done, std::uint64_t all) {
        EXPECT_GT(done, last);
        last = done;
        total = all;
    });
    EXPECT_EQ(last, total);
    EXPECT_EQ(total, 9u);
    const std::string before = folder.read("f.tif");
    struct Stop {};
    EXPECT_THROW(write_fractal_geotiff(folder.file("f.tif"), 600, 2, FractalNumbers::float32,
                                       [](std::uint64_t done, std::uint64_t) {
                                           if (done == 4) throw Stop{};
                                       }),
                 Stop);
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_EQ(folder.read("f.tif"), before) << "what stood there stays";
}

TEST(FractalGeotiff, RefusesAPlaceThatCannotTakeIt) {
    const test_support::TemporaryFolder folder;
    test_support::expect_user_error([&] { write_fractal_geotiff(folder.path() + "/none/f.tif", 10, 1, FractalNumbers::float32); },
                                    "cannot be written");
}

}  // namespace
}  // namespace tedavis::host_sim::test_fractal_geotiff
