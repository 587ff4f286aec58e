#include "host_sim/scene_builder/grid_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/scene_builder/source_kind.hpp"
#include "tests/host_sim/scene_builder/grib_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_grid_source {
namespace {

using test_support::expect_user_error;
using test_support::RasterFile;

class GridSourceOfFiles : public ::testing::Test {
protected:
    GridSource source(const RasterFile& raster, const std::string& variable = "", const std::string& crs = "") {
        return {raster.write(folder_.path() + "/grid.tif"), variable, crs, true};
    }
    test_support::TemporaryFolder folder_;
};

TEST_F(GridSourceOfFiles, PostsAreTheMiddlesOfPixels) {
    RasterFile raster;
    raster.no_data = 1000;
    const GridSource grid = source(raster);
    EXPECT_EQ(grid.places().columns, 20);
    EXPECT_NEAR(grid.places().west_deg, 9.605, 1e-9);
    EXPECT_NEAR(grid.places().north_deg, 47.095, 1e-9);
    ASSERT_EQ(grid.planes().size(), 1u);
    const std::vector<float> values = grid.read(grid.planes()[0]);
    EXPECT_TRUE(std::isnan(values[0]));
    EXPECT_EQ(values[21], 1010);
}

/// As GDAL's writer makes it, padded as archives do.
std::string padded_grib(const std::string& tif, const std::string& path) {
    GDALAllRegister();
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GRIB");
    const GdalDataset from(GDALDataset::Open(tif.c_str()));
    const QuietGdal quiet;
    { const GdalDataset made(driver->CreateCopy(path.c_str(), from.get(), FALSE, nullptr, nullptr, nullptr)); }
    std::ofstream(path, std::ios::binary | std::ios::app) << std::string(64, '\0');
    return path;
}

TEST_F(GridSourceOfFiles, LibrariesPrintNothingIntoTheResult) {
    RasterFile raster;
    const std::string file = padded_grib(raster.write(folder_.file("grid.tif")), folder_.file("grid.grb2"));
    ::testing::internal::CaptureStdout();
    { const GdalDataset opened(GDALDataset::Open(file.c_str())); }
    EXPECT_NE(::testing::internal::GetCapturedStdout().find("SECT0"), std::string::npos) << "else this proves nothing";
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(source_kind(file, scene::LayerRole::field), SourceKind::grid);
    EXPECT_EQ(GridSource(file, "band 1", "", true).places().columns, 20);
    std::printf("result");
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "result");
}

TEST_F(GridSourceOfFiles, RowsFromNorthToSouthWhateverTheFile) {
    RasterFile raster;
    raster.transform = {9.8, -0.01, 0, 46.9, 0, 0.01};  // east to west, south to north
    const GridSource grid = source(raster);
    EXPECT_NEAR(grid.places().west_deg, 9.605, 1e-9);
    EXPECT_NEAR(grid.places().north_deg, 47.045, 1e-9);
    EXPECT_NEAR(grid.places().step_lon_deg, 0.01, 1e-12);
    const std::vector<float> values = grid.read(grid.planes()[0]);
    EXPECT_EQ(values[0], 1000 + 7 * 19 + 3 * 14) << "the file's last pixel is the one in the north-west";
    EXPECT_EQ(values.back(), 1000);
}

TEST_F(GridSourceOfFiles, LongitudesTo360) {
    RasterFile raster;
    raster.transform = {349.5, 1, 0, 50, 0, -1};
    EXPECT_NEAR(source(raster).places().west_deg, -10, 1e-9);
    raster.columns = 12;
    raster.transform = {-0.5, 30, 0, 90, 0, -12};
    EXPECT_NEAR(source(raster).places().west_deg, 14.5, 1e-9);
}

TEST_F(GridSourceOfFiles, ScaleAndOffsetAreApplied) {
    RasterFile raster;
    raster.type = GDT_Int16;
    raster.scale = 0.5;
    raster.offset = -3;
    const GridSource grid = source(raster);
    EXPECT_EQ(grid.read(grid.planes()[0])[0], 497);
}

TEST_F(GridSourceOfFiles, OneBandOfSeveral) {
    RasterFile raster;
    raster.bands = 3;
    EXPECT_EQ(source(raster).planes().size(), 3u);
    const GridSource second = source(raster, "band 2");
    ASSERT_EQ(second.planes().size(), 1u);
    EXPECT_EQ(second.read(second.planes()[0])[0], 6000);
    expect_user_error([&] { (void)source(raster, "band 4"); }, "has no band 4; its bands are 1 to 3");
    expect_user_error([&] { (void)source(raster, "band 0"); }, "has no band 0");
}

TEST_F(GridSourceOfFiles, VariablesOfBandsAreChosenByName) {
    const std::string file = folder_.file("wind.grb2");
    test_support::write_grib(file, {{2, 2, 100, 50000, 0, 10}, {2, 3, 100, 50000, 0, 20}, {2, 3, 100, 85000, 0, 30}});
    EXPECT_EQ(GridSource(file, "", "", true).planes().size(), 3u);
    const GridSource north(file, "VGRD", "", true);
    ASSERT_EQ(north.planes().size(), 2u);
    EXPECT_NEAR(double{north.read(north.planes()[0]).back()}, 20, 1e-3);
    EXPECT_EQ(north.planes()[0].level, 500) << "hPa, although GRIB 2 states 50000 Pa";
    EXPECT_EQ(north.planes()[1].level, 850);
    EXPECT_EQ(north.texts_of(north.planes()[1]).level_unit, "hPa");
    EXPECT_EQ(north.unit(), "m/s");
    expect_user_error([&] { (void)GridSource(file, "GUST", "", true); },
                      "has no variable 'GUST'; choose one of UGRD, VGRD; tedavis scene look " + file);
}

TEST_F(GridSourceOfFiles, RadarCompositesStateWhatTheirNumbersMean) {
    RasterFile raster;
    const std::string file = raster.write(folder_.file("radar.tif"));
    GDALDataset* const dataset = GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE);
    dataset->SetMetadataItem("dataset1_data1_what_nodata", "-9999000 ");
    dataset->SetMetadataItem("dataset1_data1_what_undetect", "-8888000 ");
    GDALClose(dataset);
    const GridSource grid(file, "", "", true);
    EXPECT_EQ(grid.texts_of(grid.planes()[0]).missing, -9999000);
    EXPECT_EQ(grid.texts_of(grid.planes()[0]).undetected, -8888000);
    EXPECT_TRUE(rasters_inside(file).empty());
}

TEST_F(GridSourceOfFiles, OtherSystemsAreWarped) {
    RasterFile raster;
    raster.crs = "EPSG:2056";  // Swiss LV95
    raster.transform = {2780000, 1000, 0, 1190000, 0, -1000};
    raster.value = [](int i, int) { return 10.0 * i; };
    const GridSource grid = source(raster);
    EXPECT_NEAR(grid.places().west_deg, 9.78, 0.05);
    EXPECT_NEAR(grid.places().north_deg, 46.85, 0.05);
    const std::vector<float> values = grid.read(grid.planes()[0]);
    int known = 0;
    for (const float value : values) known += std::isnan(value) ? 0 : 1;
    EXPECT_GT(known, 150);
    EXPECT_LT(known, static_cast<int>(values.size())) << "corners that the file does not cover are missing";
}

TEST_F(GridSourceOfFiles, DegreesAreAssumedOrStated) {
    RasterFile raster;
    EXPECT_FALSE(source(raster).is_assumed());
    raster.crs = "";
    EXPECT_TRUE(source(raster).is_assumed());
    EXPECT_FALSE(source(raster, "", "EPSG:4326").is_assumed());
    const std::string file = raster.write(folder_.path() + "/units.tif");
    GDALDataset* const dataset = GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE);
    dataset->SetMetadataItem("longitude#units", "degrees_east");
    GDALClose(dataset);
    EXPECT_FALSE(GridSource(file, "", "", true).is_assumed()) << "netCDF says so of its axes";
}

TEST_F(GridSourceOfFiles, WithoutASystemItMustBeNamedUnlessItLooksLikeDegrees) {
    RasterFile raster;
    raster.crs = "";
    EXPECT_NEAR(source(raster).places().west_deg, 9.605, 1e-9);
    raster.transform = {2780000, 1000, 0, 1190000, 0, -1000};
    expect_user_error([&] { (void)source(raster); }, "name it with crs = \"EPSG:...\"");
    EXPECT_NEAR(source(raster, "", "EPSG:2056").places().west_deg, 9.78, 0.05);
    expect_user_error([&] { (void)source(raster, "", "EPSG:nonsense"); }, "check 'crs'");
    raster.columns = 500;
    raster.transform = {0, 1, 0, 20, 0, -1};  // metres near their origin: one corner could be degrees
    expect_user_error([&] { (void)source(raster); }, "name it with crs = \"EPSG:...\"");
    raster.crs = "EPSG:4326";
    expect_user_error([&] { (void)source(raster); }, "reach more than once round the Earth");
}

TEST_F(GridSourceOfFiles, WhatIsNoRasterIsSaid) {
    expect_user_error([&] { (void)GridSource(folder_.path() + "/none.tif", "", "", true); }, "none.tif");
    std::ofstream(folder_.path() + "/text.tif") << "not a raster";
    expect_user_error([&] { (void)GridSource(folder_.path() + "/text.tif", "", "", true); }, "not a raster that GDAL can read");
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_source
