#include "host_sim/terrain_builder/raster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_raster {
namespace {

using terrain::PostClass;
using test_support::expect_user_error;
using test_support::RasterFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RasterTest : public ::testing::Test {
protected:
    Raster load(const RasterFile& raster, const RasterOptions& options = {}) {
        return load_rasters({raster.write(folder_.file("r.tif"))}, options);
    }
    void refuses(const RasterFile& raster, const std::string& words, const RasterOptions& options = {}) {
        expect_user_error([&] { (void)load(raster, options); }, words);
    }

    test_support::TemporaryFolder folder_;
};

// Oracle: GDAL asked for each pixel by itself, as gdallocationinfo does.
TEST_F(RasterTest, TheShippedRasterIsReadPostByPost) {
    const std::string path = test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif";
    const Raster raster = load_rasters({path}, {});
    EXPECT_EQ(raster.columns, 403u);
    EXPECT_EQ(raster.rows, 344u);
    EXPECT_FALSE(raster.resampled);
    EXPECT_EQ(raster.source, "jacksboro_srtm3.tif");
    std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(path.c_str()));
    double t[6];
    ASSERT_EQ(file->GetGeoTransform(t), CE_None);
    EXPECT_DOUBLE_EQ(raster.west_deg, t[0] + 0.5 * t[1]);
    EXPECT_DOUBLE_EQ(raster.north_deg, t[3] + 0.5 * t[5]);
    float lowest = 1e9f, highest = -1e9f;
    for (std::uint32_t j = 0; j < raster.rows; ++j) {
        for (std::uint32_t i = 0; i < raster.columns; ++i) {
            double pixel = 0;
            ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Read, static_cast<int>(i), static_cast<int>(j), 1, 1, &pixel, 1, 1,
                                                       GDT_Float64, 0, 0),
                      CE_None);
            ASSERT_EQ(raster.height_m[raster.at(i, j)], static_cast<float>(pixel));
            lowest = std::min(lowest, raster.height_m[raster.at(i, j)]);
            highest = std::max(highest, raster.height_m[raster.at(i, j)]);
        }
    }
    EXPECT_EQ(lowest, 236);
    EXPECT_EQ(highest, 1076);
}

TEST_F(RasterTest, LandSeaAndVoidAreClasses) {
    RasterFile file;
    file.no_data = -9999;
    file.value = [](int i, int) { return i == 0 ? -9999.0 : i < 5 ? 0.0 : i == 5 ? -3.0 : 40.0; };
    const Raster raster = load(file);
    EXPECT_EQ(raster.post_class[raster.at(0, 3)], PostClass::void_);
    EXPECT_TRUE(std::isnan(raster.height_m[raster.at(0, 3)]));
    EXPECT_EQ(raster.post_class[raster.at(4, 3)], PostClass::sea);
    EXPECT_EQ(raster.post_class[raster.at(5, 3)], PostClass::land) << "land below the sea";
    EXPECT_EQ(raster.void_posts, 15u);
}

TEST_F(RasterTest, BoundsTakeThePostsInside) {
    const RasterFile file;  // posts at 9.605 + 0.01 i, 47.095 - 0.01 j
    RasterOptions options;
    options.bounds = GeoBounds{9.625, 46.98, 9.66, 47.055};
    for (const double turns : {0.0, 360.0, -360.0}) {
        RasterOptions turned = options;
        turned.bounds->west_deg += turns;
        turned.bounds->east_deg += turns;
        const Raster raster = load(file, turned);
        EXPECT_EQ(raster.columns, 4u) << "9.625 lies on a post and counts";
        EXPECT_EQ(raster.rows, 8u);
        EXPECT_NEAR(raster.west_deg, 9.625, 1e-9);
        EXPECT_NEAR(raster.north_deg, 47.055, 1e-9);
        EXPECT_EQ(raster.height_m[0], file.value(2, 4));
    }
    options.bounds = GeoBounds{20, 10, 30, 11};
    refuses(file, "--bounds: fewer than 2 by 2 posts", options);
    options.bounds = GeoBounds{9.6, 46, 9.61, 48};
    refuses(file, "--bounds: fewer than 2 by 2 posts", options);
}

TEST_F(RasterTest, OneFileAcrossTheAntimeridianKeepsItsPosts) {
    RasterFile file;
    file.transform = {179.9, 0.01, 0, -17, 0, -0.01};
    const Raster raster = load(file);
    EXPECT_FALSE(raster.resampled);
    EXPECT_NEAR(raster.west_deg, 179.905, 1e-9);
    EXPECT_EQ(raster.height_m[raster.at(19, 0)], file.value(19, 0));
    file.transform[0] = 350;
    EXPECT_NEAR(load(file).west_deg, -9.995, 1e-9) << "longitudes begin within -180 and 180";
}

TEST_F(RasterTest, EllipsoidHeightsBecomeHeightsAboveSeaLevel) {
    RasterFile file;
    file.value = [](int i, int) { return i == 3 ? 0.0 : 100.0; };
    RasterOptions options;
    options.vertical_datum = VerticalDatum::ellipsoid;
    const Raster raster = load(file, options);
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    for (const std::uint32_t j : {0u, 14u}) {
        const double undulation = geoid.undulation(base::radians(47.095 - 0.01 * j), base::radians(9.605)).m;
        EXPECT_GT(undulation, 40);
        EXPECT_NEAR(raster.height_m[raster.at(0, j)], 100 - undulation, 1e-3);
    }
    EXPECT_EQ(raster.post_class[raster.at(3, 0)], PostClass::land) << "zero above the ellipsoid is not the sea";
}

TEST_F(RasterTest, SeveralFilesBecomeOne) {
    RasterFile west, east;
    east.transform[0] += 0.2;
    east.value = [](int i, int j) { return 1000.0 + 7 * (i + 20) + 3 * j; };
    const Raster raster = load_rasters({west.write(folder_.file("west.tif")), east.write(folder_.file("east.tif"))}, {});
    EXPECT_EQ(raster.source, "west.tif, east.tif");
    EXPECT_TRUE(raster.resampled);
    ASSERT_EQ(raster.columns, 40u);
    ASSERT_EQ(raster.rows, 15u);
    for (std::uint32_t j = 0; j < 15; ++j)
        for (std::uint32_t i = 0; i < 40; ++i) EXPECT_NEAR(raster.height_m[raster.at(i, j)], 1000.0 + 7 * i + 3 * j, 1e-2);
    EXPECT_EQ(raster.void_posts, 0u);
}

TEST_F(RasterTest, MoreBandsAreNoted) {
    RasterFile file;
    EXPECT_THAT(load(file).notes, IsEmpty());
    file.bands = 2;
    const Raster raster = load(file);
    EXPECT_THAT(raster.notes, ElementsAre(HasSubstr("has 2 bands; heights are taken from the first")));
    EXPECT_EQ(raster.height_m[0], file.value(0, 0));
}

TEST_F(RasterTest, RefusesWhatCannotBeTerrain) {
    expect_user_error([] { (void)load_rasters({}, {}); }, "no raster named");
    RasterFile file;
    file.value = [](int, int) { return std::nan(""); };
    refuses(file, "no post has a height from -500 to 9000 m");
    file = {};
    file.columns = 1;
    refuses(file, "fewer than 2 by 2 posts");
    file = {};
    file.transform = {600000, 25, 0, 200000, 0, -25};  // metres that are called degrees
    refuses(file, "beyond the poles");
    RasterOptions options;
    options.crs = "EPSG:21781";
    EXPECT_EQ(load(file, options).notes.size(), 0u) << "a control: with its own system it is fine";
}

}  // namespace
}  // namespace tedavis::host_sim::test_raster
