#include "host_sim/terrain_builder/vertical_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/base/units.hpp"
#include "tests/host_sim/terrain_builder/height_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_vertical_reference {
namespace {

using test_support::expect_user_error;
using test_support::RasterFile;

OGRSpatialReference system(const char* name) {
    OGRSpatialReference crs;
    EXPECT_EQ(crs.SetFromUserInput(name), OGRERR_NONE) << name;
    return crs;
}

TEST(VerticalReference, IsThatOfTheVerticalPart) {
    EXPECT_FALSE(vertical_reference(system("EPSG:4326")).datum);
    EXPECT_FALSE(vertical_reference(system("EPSG:2056")).datum);
    EXPECT_EQ(vertical_reference(system("EPSG:4326+5773")).datum, VerticalDatum::egm96);
    EXPECT_EQ(vertical_reference(system("EPSG:2056+5728")).name, "LN02 height");
    EXPECT_EQ(vertical_reference(system("EPSG:4979")).datum, VerticalDatum::ellipsoid);
    EXPECT_TRUE(vertical_reference(system("EPSG:4326+5715")).is_depth);
    EXPECT_FALSE(vertical_reference(system("EPSG:4326+5714")).is_depth);
    EXPECT_EQ(metres_per_unit(vertical_reference(system("EPSG:4326+6360")).unit), 1200.0 / 3937);
}

TEST(VerticalReference, TellsOtherSeaLevelsFromEgm96) {
    for (const char* other : {"EPSG:4326+3855", "EPSG:2056+5728", "EPSG:4269+5703"})
        EXPECT_TRUE(is_other_sea_level(vertical_reference(system(other)))) << other;
    for (const char* same : {"EPSG:4326", "EPSG:4326+5773", "EPSG:4979", "EPSG:4326+5714"})
        EXPECT_FALSE(is_other_sea_level(vertical_reference(system(same)))) << same;
}

TEST(VerticalReference, LeavesAHorizontalSystem) {
    for (const char* full : {"EPSG:4326+5773", "EPSG:4979", "EPSG:9707"}) {
        const OGRSpatialReference flat = horizontal_part(system(full)), wgs84 = system("EPSG:4326");
        EXPECT_EQ(flat.GetAxesCount(), 2) << full;
        EXPECT_STREQ(flat.GetName(), wgs84.GetName()) << full;
    }
}

class DatumOfFiles : public ::testing::Test {
protected:
    DatumOfFiles() {
        level_.value = [](int, int) { return 100.0; };
    }
    std::string file(const char* crs) {
        level_.crs = crs;
        return level_.write(folder_.file(std::string(crs).substr(5) + ".tif"));
    }
    static double undulation_m(const Raster& raster) {
        return GeoidEgm96::installed().undulation(base::radians(raster.north_deg), base::radians(raster.west_deg)).m;
    }

    RasterFile level_;
    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
};

TEST_F(DatumOfFiles, EllipsoidalHeightsThatAFileStatesAreUsedAsSuch) {
    const Raster raster = load_rasters({file("EPSG:4979")}, {});
    EXPECT_EQ(raster.vertical_datum, VerticalDatum::ellipsoid);
    EXPECT_NEAR(raster.height_m[0], 100 - undulation_m(raster), 1e-3);
    EXPECT_EQ(load_rasters({file("EPSG:4326+5773")}, {}).height_m[0], 100);
    RasterOptions options;
    options.crs = "EPSG:4979";
    EXPECT_LT(load_rasters({file("EPSG:4326")}, options).height_m[0], 60) << "a system of the option says it as well";
}

TEST_F(DatumOfFiles, ContradictionsAreRefused) {
    RasterOptions options;
    options.vertical_datum = VerticalDatum::ellipsoid;
    for (const char* crs : {"EPSG:4326+5773", "EPSG:4326+3855"})
        expect_user_error([&] { (void)load_rasters({file(crs)}, options); }, "which contradicts --vertical-datum ellipsoid");
    EXPECT_LT(load_rasters({file("EPSG:4979")}, options).height_m[0], 60);
    options.vertical_datum = VerticalDatum::egm96;
    expect_user_error([&] { (void)load_rasters({file("EPSG:4979")}, options); }, "which contradicts --vertical-datum egm96");
    EXPECT_EQ(load_rasters({file("EPSG:4326+5773")}, options).height_m[0], 100);
    expect_user_error([&] { (void)load_rasters({file("EPSG:4326+5715")}, {}); }, "holds depths");
}

TEST_F(DatumOfFiles, EachFileOfAMosaicKeepsItsOwn) {
    const std::string sea_level = file("EPSG:4326");
    level_.transform[0] += 0.2;
    const Raster raster = load_rasters({sea_level, file("EPSG:4979")}, {});
    EXPECT_EQ(raster.vertical_datum, VerticalDatum::egm96) << "not all of them are ellipsoidal";
    EXPECT_EQ(raster.height_m[raster.at(2, 2)], 100);
    EXPECT_NEAR(raster.height_m[raster.at(38, 2)], 100 - 49, 4);
}

TEST_F(DatumOfFiles, UsgsHeadersNameTheirSeaLevel) {
    RasterFile whole = level_;
    whole.type = GDT_Int16;
    const std::string path = test_support::write_as("USGSDEM", whole, folder_.file("a.dem"));
    test_support::patch_file(path, 888, " 3");
    const Raster raster = load_rasters({path}, {});
    ASSERT_EQ(raster.notes.size(), 1u);
    EXPECT_NE(raster.notes[0].find("above 'NAVD 88'"), std::string::npos);
    RasterOptions options;
    options.vertical_datum = VerticalDatum::ellipsoid;
    expect_user_error([&] { (void)load_rasters({path}, options); }, "above 'NAVD 88', which contradicts");
}

}  // namespace
}  // namespace tedavis::host_sim::test_vertical_reference
