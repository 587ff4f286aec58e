#include "host_sim/scene_builder/grid_look.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/scene_builder/grib_file.hpp"
#include "tests/host_sim/scene_builder/netcdf_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_grid_look {
namespace {

using test_support::GribGrid;
using test_support::RasterFile;

TEST(GridLook, BandsWithoutNamesAreKnownByTheirNumbers) {
    const test_support::TemporaryFolder folder;
    RasterFile raster;
    raster.bands = 2;
    raster.unit = "dBZ";
    raster.no_data = 1000;
    const GridLook look = look_at_grid(raster.write(folder.file("grid.tif")), "");
    EXPECT_EQ(look.format, "GTiff");
    EXPECT_NE(look.system.find("EPSG:4326"), std::string::npos) << look.system;
    ASSERT_EQ(look.variables.size(), 2u);
    const VariableLook& first = look.variables[0];
    EXPECT_EQ(first.name, "band 1");
    EXPECT_EQ(look.variables[1].name, "band 2");
    EXPECT_EQ(first.unit, "dBZ");
    EXPECT_TRUE(first.levels.empty() && first.times_ns.empty());
    EXPECT_EQ(first.most_members, 1u);
    ASSERT_TRUE(first.range);
    EXPECT_EQ(first.range->least, 1003) << "1000 means that there is no value";
    EXPECT_EQ(first.range->greatest, 1000 + 7 * 19 + 3 * 14);
    EXPECT_NEAR(first.missing_share, 1.0 / 300, 1e-12);
}

TEST(GridLook, NumbersThatMeanNoValueAreSuspected) {
    const test_support::TemporaryFolder folder;
    RasterFile raster;
    raster.value = [](int i, int) { return i < 5 ? -9999.0 : 10.0 + i; };
    const GridLook look = look_at_grid(raster.write(folder.file("grid.tif")), "");
    EXPECT_EQ(look.variables[0].special, std::vector<double>{-9999});
    EXPECT_EQ(look.variables[0].range->least, 15);
    EXPECT_NEAR(look.variables[0].missing_share, 0.25, 1e-12);
    raster.value = [](int i, int) { return i < 5 ? -9998.0 : 10.0 + i; };
    EXPECT_TRUE(look_at_grid(raster.write(folder.file("plain.tif")), "").variables[0].special.empty());
}

TEST(GridLook, NetcdfStatesItsTimes) {
    const test_support::TemporaryFolder folder;
    test_support::NetcdfFile file;
    file.times_h = {6, 9, 12};
    file.write(folder.file("u.nc"));
    const GridLook look = look_at_grid(folder.file("u.nc"), "");
    ASSERT_EQ(look.variables.size(), 1u);
    EXPECT_EQ(look.variables[0].name, "u");
    EXPECT_EQ(look.variables[0].unit, "m s**-1");
    EXPECT_EQ(look.variables[0].times_ns.size(), 3u);
    EXPECT_EQ(look.variables[0].times_ns[1], std::int64_t{9} * 3600 * 1'000'000'000);
    EXPECT_TRUE(look.variables[0].is_whole);
}

TEST(GridLook, GribHasVariablesLevelsAndMembers) {
    const test_support::TemporaryFolder folder;
    const std::string file = folder.file("wind.grb2");
    test_support::write_grib(file, {{2, 2, 100, 50000, 0, 10},
                                    {2, 2, 100, 85000, 0, 8},
                                    {2, 2, 100, 50000, 3, 11},
                                    {2, 3, 100, 50000, 0, 1},
                                    {2, 3, 100, 50000, 0, 3}});
    const GridLook look = look_at_grid(file, "");
    ASSERT_EQ(look.variables.size(), 2u);
    const VariableLook &u = look.variables[0], &v = look.variables[1];
    EXPECT_EQ(u.name, "UGRD");
    EXPECT_EQ(v.name, "VGRD");
    EXPECT_EQ(u.unit, "m/s");
    EXPECT_EQ(u.level_unit, "hPa");
    EXPECT_EQ(u.levels, (std::vector<double>{500, 850})) << "GRIB 2 states them in Pa";
    EXPECT_EQ(u.times_ns.size(), 2u);
    EXPECT_FALSE(u.is_whole) << "850 hPa has one of the two times";
    EXPECT_EQ(u.fullest_level, 500);
    EXPECT_EQ(v.least_members, 2u);
    EXPECT_EQ(v.most_members, 2u);
    EXPECT_NEAR(v.first_spread, std::sqrt(2.0), 1e-3) << "sample standard deviation of 1 and 3";
}

TEST(GridLook, WhatIsNoRasterIsRefused) {
    const test_support::TemporaryFolder folder;
    const std::string file = folder.write("text.tif", "not a raster");
    test_support::expect_user_error([&] { (void)look_at_grid(file, ""); }, "not a raster that GDAL can read");
    RasterFile raster;
    raster.crs = "";
    raster.transform = {2780000, 1000, 0, 1190000, 0, -1000};
    const std::string swiss = raster.write(folder.file("swiss.tif"));
    test_support::expect_user_error([&] { (void)look_at_grid(swiss, ""); }, "name it with crs");
    EXPECT_TRUE(look_at_grid(swiss, "EPSG:2056").is_warped);
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_look
