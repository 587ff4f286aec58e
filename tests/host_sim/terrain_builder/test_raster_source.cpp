#include "host_sim/terrain_builder/raster_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host_sim/quiet_gdal.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_raster_source {
namespace {

using test_support::expect_user_error;
using test_support::RasterFile;

class RasterSourceTest : public ::testing::Test {
protected:
    RasterSource open(const RasterFile& raster, const RasterOptions& options = {}) {
        return open_raster_source(raster.write(folder_.file("r.tif")), options);
    }
    std::vector<float> heights(const RasterFile& raster, const RasterOptions& options = {}) {
        return read_heights(open(raster, options), {0, 0, raster.columns, raster.rows}, options);
    }
    void refuses(const RasterFile& raster, const std::string& words, const RasterOptions& options = {}) {
        expect_user_error([&] { (void)open(raster, options); }, words);
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
};

TEST_F(RasterSourceTest, GivesEveryNumberTypeAsMetres) {
    RasterFile raster;
    for (const GDALDataType type : {GDT_UInt16, GDT_Int16, GDT_UInt32, GDT_Int32, GDT_Float32, GDT_Float64}) {
        raster.type = type;
        const std::vector<float> read = heights(raster);
        for (int j = 0; j < raster.rows; ++j)
            for (int i = 0; i < raster.columns; ++i)
                ASSERT_EQ(read[static_cast<std::size_t>(j * raster.columns + i)], raster.value(i, j))
                    << GDALGetDataTypeName(type);
    }
}

TEST_F(RasterSourceTest, ReadsTheWindowItIsAskedFor) {
    const RasterFile raster;
    const std::vector<float> read = read_heights(open(raster), {3, 2, 4, 5}, {});
    ASSERT_EQ(read.size(), 20u);
    EXPECT_EQ(read[0], raster.value(3, 2));
    EXPECT_EQ(read[19], raster.value(6, 6));
}

TEST_F(RasterSourceTest, UnitsAndScalesBecomeMetres) {
    struct Case {
        const char* unit;
        double metres;
    };
    for (const Case& c : {Case{"m", 1}, Case{"metre", 1}, Case{"Meters", 1}, Case{"ft", 0.3048}, Case{"foot", 0.3048},
                          Case{"US survey foot", 1200.0 / 3937}, Case{"cm", 0.01}, Case{"km", 1000}}) {
        RasterFile raster;
        raster.unit = c.unit;
        raster.value = [&](int i, int j) { return (100.0 + i + j) / c.metres; };
        EXPECT_NEAR(heights(raster)[0], 100, 1e-4) << c.unit;
    }
    RasterFile scaled;
    scaled.scale = 0.1;
    scaled.offset = -50;
    scaled.unit = "ft";
    scaled.type = GDT_Int16;
    EXPECT_NEAR(heights(scaled)[0], (1000 * 0.1 - 50) * 0.3048, 1e-4);
}

TEST_F(RasterSourceTest, WhatIsNoLengthIsNoHeight) {
    RasterFile raster;
    raster.unit = "dBZ";
    refuses(raster, "its values are in 'dBZ', which is no length");
}

TEST_F(RasterSourceTest, MarkedValuesAreVoids) {
    RasterFile raster;
    raster.value = [](int i, int j) { return i == 4 && j == 3 ? -32768.0 : 500.0; };
    raster.type = GDT_Int16;
    const std::size_t marked = 3 * 20 + 4;
    for (const bool declared : {true, false}) {
        if (declared) raster.no_data = -32768;
        const std::vector<float> read = heights(raster);
        for (std::size_t n = 0; n < read.size(); ++n) ASSERT_EQ(std::isnan(read[n]), n == marked) << n;
    }
    raster.value = [](int i, int j) { return i == 4 && j == 3 ? 12.0 : 500.0; };
    raster.no_data.reset();
    EXPECT_EQ(heights(raster)[marked], 12) << "a control: nothing says that it is a mark";
    RasterOptions options;
    options.void_value = 12;
    EXPECT_TRUE(std::isnan(heights(raster, options)[marked]));
}

TEST_F(RasterSourceTest, MarksAreOfTheStoredNumbersNotOfTheMetres) {
    RasterFile raster;
    raster.scale = 0.1;
    raster.no_data = 30000;  // 3000 m in the scaled sense, which is a fine height
    raster.type = GDT_Int16;
    raster.value = [](int i, int) { return i == 0 ? 30000.0 : 3000.0; };
    const std::vector<float> read = heights(raster);
    EXPECT_TRUE(std::isnan(read[0]));
    EXPECT_NEAR(read[1], 300, 1e-4);
}

TEST_F(RasterSourceTest, NoNumbersAndImpossibleHeightsAreVoids) {
    RasterFile raster;
    const std::vector<double> bad = {
        std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), -500.5, 9000.5, 1e30};
    raster.value = [&](int i, int j) { return j == 0 && i < 6 ? bad[static_cast<std::size_t>(i)] : -500.0; };
    for (const bool declared : {false, true}) {
        if (declared) raster.no_data = std::nan("");
        const std::vector<float> read = heights(raster);
        for (std::size_t n = 0; n < read.size(); ++n) ASSERT_EQ(std::isnan(read[n]), n < 6) << n;
    }
}

TEST_F(RasterSourceTest, KnowsALatticeOfWgs84UnderEveryName) {
    RasterFile raster;
    for (const char* crs : {"EPSG:4326", "OGC:CRS84", "EPSG:4979", "EPSG:4258", "EPSG:9707"}) {
        raster.crs = crs;
        EXPECT_TRUE(open(raster).plain) << crs;
    }
    for (const char* crs : {"EPSG:4149", "EPSG:4807"}) {  // CH1903 lies about 100 m off; the Paris meridian and grads
        raster.crs = crs;
        EXPECT_FALSE(open(raster).plain) << crs;
    }
    raster.crs = "EPSG:21781";
    raster.transform = {600000, 25, 0, 200000, 0, -25};
    EXPECT_FALSE(open(raster).plain);
    raster = {};
    raster.transform = {9.6, 0.01, 0.001, 47.1, 0, -0.01};
    EXPECT_FALSE(open(raster).plain) << "sheared";
    raster.transform = {9.6, 0.01, 0, 46.9, 0, 0.01};
    EXPECT_FALSE(open(raster).plain) << "south up";
}

TEST_F(RasterSourceTest, TheUserMayNameTheCoordinateSystem) {
    RasterFile raster;
    raster.crs.clear();
    refuses(raster, "names no coordinate system; give it with --crs");
    RasterOptions options;
    options.crs = "EPSG:4326";
    EXPECT_TRUE(open(raster, options).plain);
    options.crs = "nonsense";
    refuses(raster, "--crs nonsense: unknown coordinate system", options);
}

TEST_F(RasterSourceTest, PicturesAreNotHeights) {
    RasterFile raster;
    raster.type = GDT_Byte;
    raster.bands = 3;
    raster.meaning = GCI_RedBand;
    refuses(raster, "first band holds colours");
    raster = {};
    raster.type = GDT_CFloat32;
    refuses(raster, "complex numbers");
}

TEST_F(RasterSourceTest, FilesThatAreNoRasters) {
    const auto refused = [&](const std::string& path, const std::string& words) {
        expect_user_error([&] { (void)open_raster_source(path, {}); }, words);
    };
    refused(folder_.file("none.tif"), "none.tif: no such file");
    refused(folder_.write("empty.tif", ""), "empty.tif: not a raster that GDAL can read");
    refused(folder_.write("words.tif", "these are words\n"), "words.tif: not a raster");
    refused(folder_.path(), "not a raster");
    refused(folder_.write("noise.zip", "PK\3\4 and so on"), "no raster inside this archive");
    refused(folder_.write("plain.pgm", "P5 4 4 255\n0123456789abcdef"), "does not say where on Earth it lies");
}

TEST_F(RasterSourceTest, ATruncatedFileIsFound) {
    RasterFile raster;
    raster.columns = raster.rows = 200;
    raster.write(folder_.file("whole.tif"));
    const std::string bytes = folder_.read("whole.tif");
    for (const double share : {0.3, 0.7, 0.99}) {
        const std::string path =
            folder_.write("cut.tif", bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
        expect_user_error([&] { (void)read_heights(open_raster_source(path, {}), {0, 0, 200, 200}, {}); }, "cut.tif: ");
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_raster_source
