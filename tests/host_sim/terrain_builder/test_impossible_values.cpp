#include "host_sim/terrain_builder/impossible_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_impossible_values {
namespace {

ImpossibleValues found_in(const test_support::RasterFile& file) {
    const test_support::TemporaryFolder place;
    return impossible_values(open_raster_source(file.write(place.file("r.tif")), {}), {});
}

TEST(ImpossibleValues, GroundAndDeclaredVoidsHaveNone) {
    test_support::RasterFile file;
    EXPECT_EQ(found_in(file).share, 0);
    file.no_data = -32768;
    file.value = [](int i, int) { return i < 5 ? -32768.0 : 100.0; };
    EXPECT_EQ(found_in(file).share, 0);
    file.no_data.reset();
    file.value = [](int i, int) { return i < 5 ? std::nan("") : 100.0; };
    EXPECT_EQ(found_in(file).share, 0) << "not a number marks a void by itself";
}

TEST(ImpossibleValues, AreToldByTheirShareAndRangeAlsoOfALargeRaster) {
    test_support::RasterFile file;
    file.columns = 300, file.rows = 200;
    file.transform[1] = 0.001, file.transform[5] = -0.001;
    file.value = [](int i, int j) { return i < 150 ? 500.0 : j < 100 ? -9999000.0 : 20000.0; };
    const ImpossibleValues found = found_in(file);
    EXPECT_NEAR(found.share, 0.5, 0.02);
    EXPECT_EQ(found.lowest_m, -9999000);
    EXPECT_EQ(found.highest_m, 20000);
}

TEST(ImpossibleValues, AreMeasuredInMetres) {
    test_support::RasterFile file;
    file.unit = "cm";
    file.value = [](int, int) { return 250000.0; };
    EXPECT_EQ(found_in(file).share, 0) << "2500 m";
    file.unit = "m";
    EXPECT_EQ(found_in(file).share, 1);
    EXPECT_EQ(found_in(file).lowest_m, 250000);
}

}  // namespace
}  // namespace tedavis::host_sim::test_impossible_values
