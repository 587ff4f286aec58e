#include "host_sim/scene_builder/grid_variables.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/scene_builder/netcdf_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_grid_variables {
namespace {

constexpr std::int64_t kHour_ns = 3600LL * 1'000'000'000;

class GridVariables : public ::testing::Test {
protected:
    /// Tells the file more about itself.
    static void describe(const std::string& path, const std::vector<std::pair<std::string, std::string>>& items) {
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(path.c_str(), GDAL_OF_UPDATE));
        ASSERT_NE(file, nullptr);
        for (const auto& [key, value] : items) file->SetMetadataItem(key.c_str(), value.c_str());
    }
    test_support::TemporaryFolder folder_;
};

TEST_F(GridVariables, BandsWithoutNamesAreOneEach) {
    test_support::RasterFile raster;
    raster.unit = "K";
    const auto one = grid_variables(raster.write(folder_.file("one.tif")));
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].name, "band 1");
    EXPECT_EQ(one[0].unit, "K");
    EXPECT_FALSE(one[0].has_levels || one[0].first_ns || one[0].missing || one[0].undetected);
    raster.bands = 3;
    const auto three = grid_variables(raster.write(folder_.file("three.tif")));
    ASSERT_EQ(three.size(), 3u);
    EXPECT_EQ(three[2].name, "band 3");
}

TEST_F(GridVariables, NetcdfSaysWhatItIsAndOfWhichTimes) {
    test_support::NetcdfFile file;
    file.times_h = {438'288, 438'289, 438'290};
    file.write(folder_.file("u.nc"));
    const auto variables = grid_variables(folder_.file("u.nc"));
    ASSERT_EQ(variables.size(), 1u) << "three times of one variable";
    EXPECT_EQ(variables[0].name, "u");
    EXPECT_EQ(variables[0].quantity, "eastward_wind");
    EXPECT_EQ(variables[0].first_ns, 438'288 * kHour_ns);
    EXPECT_EQ(variables[0].last_ns, 438'290 * kHour_ns);
}

TEST_F(GridVariables, OdimSaysItsQuantityAndWhatIsNoValue) {
    const std::string path = test_support::RasterFile().write(folder_.file("radar.tif"));
    describe(path, {{"dataset1_data1_quality1_what_nodata", "-1"},
                    {"dataset1_data1_what_quantity", "DBZH"},
                    {"dataset1_data1_what_nodata", "-9999000 "},
                    {"dataset1_data1_what_undetect", "-8888000 "}});
    const auto variables = grid_variables(path);
    ASSERT_EQ(variables.size(), 1u);
    EXPECT_EQ(variables[0].quantity, "DBZH");
    EXPECT_EQ(variables[0].missing, -9999000);
    EXPECT_EQ(variables[0].undetected, -8888000);
}

TEST_F(GridVariables, WhatIsNoRasterIsRefused) {
    using test_support::expect_user_error;
    expect_user_error([&] { (void)grid_variables(folder_.file("missing.tif")); }, "missing.tif");
    expect_user_error([&] { (void)grid_variables(folder_.write("words.tif", "words")); }, "not a raster that GDAL can read");
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_variables
