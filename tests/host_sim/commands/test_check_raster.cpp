#include "host_sim/commands/check_raster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/paths.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_check_raster {
namespace {

using ::testing::HasSubstr;

TEST(CheckRaster, GroundIsSoundWithoutAWord) {
    const test_support::TemporaryFolder place;
    const CheckedFile ground = check_raster(test_support::RasterFile().write(place.file("r.tif")));
    EXPECT_EQ(ground.is, "a height raster of 20 x 15 posts, 0 of them void");
    EXPECT_TRUE(ground.warnings.empty());
    EXPECT_TRUE(check_raster(test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif").warnings.empty());
}

TEST(CheckRaster, AnImageOfSomethingElseIsSaid) {
    const test_support::TemporaryFolder place;
    test_support::RasterFile echo;
    echo.value = [](int i, int j) { return (i + j) % 20 == 0 ? 30.0 : -8888000.0; };
    const CheckedFile radar = check_raster(echo.write(place.file("echo.tif")));
    ASSERT_EQ(radar.warnings.size(), 2u);
    EXPECT_EQ(radar.warnings[1].name, "heights.impossible");
    EXPECT_EQ(radar.warnings[0].name, "heights.void");
    EXPECT_THAT(radar.warnings[0].text, HasSubstr("echo.tif: 95 % of 300 posts have no height"));
    test_support::RasterFile grey;
    grey.type = GDT_Byte;
    grey.value = [](int i, int j) { return (i * 11 + j * 7) % 256; };
    const CheckedFile picture = check_raster(grey.write(place.file("grey.tif")));
    ASSERT_EQ(picture.warnings.size(), 1u);
    EXPECT_EQ(picture.warnings[0].name, "heights.eight_bit");
}

TEST(CheckRaster, NoHeightAtAllIsRefused) {
    const test_support::TemporaryFolder place;
    test_support::RasterFile nothing;
    nothing.value = [](int, int) { return -8888000.0; };
    const std::string path = nothing.write(place.file("n.tif"));
    test_support::expect_user_error([&] { (void)check_raster(path); }, "n.tif: no post has a height from -500 to 9000 m");
}

}  // namespace
}  // namespace tedavis::host_sim::test_check_raster
