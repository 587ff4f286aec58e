#include "host_sim/terrain_builder/stated_quantity.hpp"

#include <gtest/gtest.h>

#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/terrain_builder/raster_source.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_stated_quantity {
namespace {

class StatedQuantity : public ::testing::Test {
protected:
    /// Of a raster whose dataset, or first band, has this line in its metadata.
    std::string with(const std::string& key, const std::string& value, bool of_band = false) {
        const std::string path = test_support::RasterFile().write(folder_.file("x.tif"));
        const GdalDataset file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
        if (of_band)
            file->GetRasterBand(1)->SetMetadataItem(key.c_str(), value.c_str());
        else
            file->SetMetadataItem(key.c_str(), value.c_str());
        return other_quantity(*file).value_or("");
    }
    test_support::TemporaryFolder folder_;
};

TEST_F(StatedQuantity, RadarAndTemperatureAreNoHeights) {
    EXPECT_EQ(with("dataset1_data1_what_quantity", "DBZH"), "'DBZH' (dataset1_data1_what_quantity)");
    EXPECT_EQ(with("quantity", "RATE"), "'RATE' (quantity)");
    EXPECT_EQ(with("units", "dBZ"), "'dBZ' (units)");
    EXPECT_EQ(with("units", "K", true), "'K' (units)");
    EXPECT_EQ(with("standard_name", "air_temperature", true), "'air_temperature' (standard_name)");
}

TEST_F(StatedQuantity, WhatMayBeAHeightIsLeftAlone) {
    for (const char* name : {"surface_altitude", "height_above_mean_sea_level", "bedrock_altitude", "Elevation"})
        EXPECT_EQ(with("standard_name", name, true), "") << name;
    for (const char* unit : {"m", "Meters", "feet", "metres above sea level", "m (EGM96)", ""})
        EXPECT_EQ(with("units", unit), "");
    EXPECT_EQ(with("lat#units", "degrees_north"), "") << "of a coordinate";
    EXPECT_EQ(with("AREA_OR_POINT", "Area"), "");
    EXPECT_EQ(with("inequantity", "DBZH"), "") << "another word";
}

TEST_F(StatedQuantity, NoTerrainIsMadeOfIt) {
    static_cast<void>(with("what_quantity", "DBZH"));
    test_support::expect_user_error([&] { (void)open_raster_source(folder_.file("x.tif"), {}); },
                                    "x.tif: says that it holds 'DBZH' (what_quantity), which is no height; give a height raster");
}

}  // namespace
}  // namespace tedavis::host_sim::test_stated_quantity
