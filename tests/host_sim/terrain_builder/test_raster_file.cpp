#include "host_sim/terrain_builder/raster_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "tests/host_sim/terrain_builder/height_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_raster_file {
namespace {

using test_support::expect_user_error;
using test_support::RasterFile;
using test_support::write_as;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kVoid = -32768;

/// Hills with fractions of metres, three posts of sea and two voids.
double hills_m(int i, int j) {
    if (j == 9 && i >= 3 && i < 6) return 0;
    if (i == 11 && (j == 4 || j == 5)) return kVoid;
    return 1500.3 + 800 * std::sin(0.31 * i) * std::cos(0.23 * j) + 7.77 * i;
}

RasterFile hills() {
    RasterFile raster;
    raster.columns = 40;
    raster.rows = 30;
    raster.transform = {9.6, 1.0 / 1200, 0, 47.1, 0, -1.0 / 1200};
    raster.no_data = kVoid;
    raster.value = hills_m;
    return raster;
}

RasterFile without_voids(RasterFile raster) {
    raster.no_data.reset();
    raster.value = [](int i, int j) { return hills_m(i, j) == kVoid ? 2000 : hills_m(i, j); };
    return raster;
}

std::ptrdiff_t sea_posts(const Raster& raster) {
    return std::count(raster.post_class.begin(), raster.post_class.end(), terrain::PostClass::sea);
}

class RasterFormats : public ::testing::Test {
protected:
    /// Every post against the formula, voids against voids.
    static void expect_heights(const Raster& raster, const RasterFile& written, double tolerance_m, double metres = 1) {
        ASSERT_EQ(raster.columns, static_cast<std::uint32_t>(written.columns));
        ASSERT_EQ(raster.rows, static_cast<std::uint32_t>(written.rows));
        EXPECT_FALSE(raster.resampled);
        EXPECT_NEAR(raster.west_deg, written.x(0, 0), 1e-6);
        EXPECT_NEAR(raster.north_deg, written.y(0, 0), 1e-6);
        EXPECT_NEAR(raster.step_lon_deg, written.transform[1], 1e-9);
        for (std::uint32_t j = 0; j < raster.rows; ++j) {
            for (std::uint32_t i = 0; i < raster.columns; ++i) {
                const double expected = written.value(static_cast<int>(i), static_cast<int>(j));
                const float height_m = raster.height_m[raster.at(i, j)];
                if (expected == kVoid) {
                    ASSERT_TRUE(std::isnan(height_m)) << i << "," << j;
                } else {
                    ASSERT_NEAR(height_m, expected * metres, tolerance_m + 1e-3) << i << "," << j;
                }
            }
        }
    }
    void refuses(const std::string& path, const std::string& words, const RasterOptions& options = {}) {
        expect_user_error([&] { (void)load_rasters({path}, options); }, words);
    }

    test_support::TemporaryFolder folder_;
    QuietGdal quiet_;
};

TEST_F(RasterFormats, EveryFormatThatStatesItsPlaceGivesItsHeightsBack) {
    struct Case {
        const char *driver, *name;
        GDALDataType type;
        double tolerance_m;
        bool holds_voids;
        std::vector<std::string> options;
    };
    for (const Case& c : {Case{"GTiff", "a.tif", GDT_Float32, 0, true, {"COMPRESS=DEFLATE", "TILED=YES"}},
                          Case{"GTiff", "i.tif", GDT_Int16, 0.5, true, {}}, Case{"HF2", "a.hf2", GDT_Float32, 0.01, false, {}},
                          Case{"HF2", "a.hfz", GDT_Float32, 0.01, false, {"COMPRESS=YES"}},
                          Case{"BT", "f.bt", GDT_Float32, 0, true, {}}, Case{"BT", "i.bt", GDT_Int16, 0.5, true, {}},
                          Case{"AAIGrid", "a.asc", GDT_Float32, 0.005, true, {"DECIMAL_PRECISION=2"}},
                          Case{"USGSDEM", "a.dem", GDT_Int16, 0.5, true, {}}, Case{"netCDF", "a.nc", GDT_Float32, 0, true, {}},
                          Case{"netCDF", "z.nc", GDT_Int16, 0.5, true, {"FORMAT=NC4", "COMPRESS=DEFLATE"}}}) {
        SCOPED_TRACE(c.name);
        RasterFile raster = hills();
        raster.type = c.type;
        if (!c.holds_voids) raster = without_voids(raster);
        const Raster read = load_rasters({write_as(c.driver, raster, folder_.file(c.name), c.options)}, {});
        expect_heights(read, raster, c.tolerance_m);
        EXPECT_EQ(read.void_posts, c.holds_voids ? 2u : 0u);
        if (c.holds_voids) {
            EXPECT_EQ(sea_posts(read), 3) << "HF2 counts from the lowest height of a tile, not from zero";
        }
        EXPECT_EQ(read.vertical_datum, VerticalDatum::egm96);
    }
}

/// One tile of SRTM3 with voids.
RasterFile srtm_tile() {
    RasterFile raster;
    raster.columns = raster.rows = 1201;
    raster.type = GDT_Int16;
    raster.no_data = kVoid;
    raster.transform = {9 - 0.5 / 1200, 1.0 / 1200, 0, 47 + 0.5 / 1200, 0, -1.0 / 1200};
    raster.value = [](int i, int j) { return (i + 3 * j) % 97 == 0 ? kVoid : (i * 7 + j * 13) % 4000 - 400; };
    return raster;
}

TEST_F(RasterFormats, AnSrtmTileIsReadAloneAndFromAnArchive) {
    const RasterFile tile = srtm_tile();
    const std::string path = write_as("SRTMHGT", tile, folder_.file("N46E009.hgt"));
    expect_heights(load_rasters({path}, {}), tile, 0);
    const std::string zip = folder_.file("tile.zip"), bytes = folder_.read("N46E009.hgt");
    VSILFILE* const inside = VSIFOpenL(("/vsizip/" + zip + "/N46E009.hgt").c_str(), "wb");
    ASSERT_NE(inside, nullptr);
    ASSERT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), inside), bytes.size());
    VSIFCloseL(inside);
    expect_heights(load_rasters({zip}, {}), tile, 0);
    refuses(folder_.write("lake.hgt", bytes), "name it after its south-west corner, such as N46E009.hgt");
    refuses(folder_.write("N46E010.hgt", bytes.substr(0, 5000)), "N46E010.hgt: not a whole SRTM tile");
    RasterOptions ellipsoid;
    ellipsoid.vertical_datum = VerticalDatum::ellipsoid;
    refuses(path, "above 'EGM96 geoid height', which contradicts --vertical-datum ellipsoid", ellipsoid);
}

double quantum_m(const std::string& path) {
    const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(GDALDataset::Open(path.c_str()));
    return file->GetRasterBand(1)->GetScale();
}

TEST_F(RasterFormats, TerragenTakesItsPlaceFromTheOptions) {
    const RasterFile raster = without_voids(hills());
    const std::string path =
        write_as("Terragen", raster, folder_.file("a.ter"), {"MINUSERPIXELVALUE=0", "MAXUSERPIXELVALUE=3000"});
    refuses(path, "a.ter: the raster does not say where on Earth it lies; give its outer edges with --extent");
    RasterOptions options;
    options.crs = "EPSG:4326";
    refuses(path, "does not say where on Earth it lies", options);
    options.crs.reset();
    options.extent = MapExtent{9.6, 47.1 - 30.0 / 1200, 9.6 + 40.0 / 1200, 47.1};
    expect_heights(load_rasters({path}, options), raster, quantum_m(path));
    options.vertical_datum = VerticalDatum::ellipsoid;
    EXPECT_EQ(load_rasters({path}, options).vertical_datum, VerticalDatum::ellipsoid);
    options.extent = MapExtent{780000, 185000, 784000, 188000};
    refuses(path, "beyond the poles", options);
    options.crs = "EPSG:21781";
    const Raster swiss = load_rasters({path}, options);
    EXPECT_TRUE(swiss.resampled);
    EXPECT_NEAR(swiss.north_deg, 46.82, 0.05);
    EXPECT_NEAR(swiss.west_deg, 9.79, 0.05);
    refuses(write_as("GTiff", hills(), folder_.file("a.tif")), "--extent: ", options);
    expect_user_error([&] { (void)load_rasters({path, path}, options); }, "more than one file does not say where it lies");
}

TEST_F(RasterFormats, VerticalUnitsOfEveryFormatBecomeMetres) {
    RasterFile feet = hills();
    feet.crs = "EPSG:4326+6360";  // NAVD88 height in US survey feet
    const Raster geotiff = load_rasters({feet.write(folder_.file("feet.tif"))}, {});
    expect_heights(geotiff, feet, 0, 1200.0 / 3937);
    EXPECT_THAT(geotiff.notes,
                ElementsAre(HasSubstr("heights are above 'NAVD88 height (ftUS)'; they are taken for heights above EGM96")));

    const std::string bt = write_as("BT", hills(), folder_.file("feet.bt"));
    for (const float scale : {0.3048f, 0.1f, 2.0f, 0.0f}) {
        test_support::patch_file(bt, 62, std::string(reinterpret_cast<const char*>(&scale), 4));
        expect_heights(load_rasters({bt}, {}), hills(), 0, scale == 0 ? 1.0 : double{scale});
    }

    RasterFile whole = hills();
    whole.type = GDT_Int16;
    const std::string dem = write_as("USGSDEM", whole, folder_.file("feet.dem"));
    test_support::patch_file(dem, 534, "     1");  // record A, unit of elevations: feet
    expect_heights(load_rasters({dem}, {}), whole, 0.1524, 0.3048);

    const std::string grid = write_as("AAIGrid", hills(), folder_.file("feet.asc"), {"DECIMAL_PRECISION=2"});
    folder_.write("feet.prj", "Projection GEOGRAPHIC\nDatum WGS84\nSpheroid WGS84\nUnits DD\nZunits FEET\nParameters\n");
    expect_heights(load_rasters({grid}, {}), hills(), 0.002, 0.3048);
    folder_.write("feet.prj", "Projection GEOGRAPHIC\nDatum WGS84\nSpheroid WGS84\nUnits DD\nZunits LEAGUES\nParameters\n");
    refuses(grid, "its values are in 'LEAGUES', which is no length");

    const std::string cdf = write_as("netCDF", hills(), folder_.file("feet.nc"), {},
                                     [](GDALDataset& d) { d.GetRasterBand(1)->SetMetadataItem("units", "ft"); });
    expect_heights(load_rasters({cdf}, {}), hills(), 0, 0.3048);
}

TEST_F(RasterFormats, WhatANetcdfVariableSaysAboutItsDatumIsHonoured) {
    const auto with = [&](const char* key, const char* value) {
        return write_as("netCDF", hills(), folder_.file("v.nc"), {},
                        [=](GDALDataset& d) { d.GetRasterBand(1)->SetMetadataItem(key, value); });
    };
    EXPECT_EQ(load_rasters({with("standard_name", "height_above_reference_ellipsoid")}, {}).vertical_datum,
              VerticalDatum::ellipsoid);
    EXPECT_EQ(load_rasters({with("standard_name", "surface_altitude")}, {}).vertical_datum, VerticalDatum::egm96);
    refuses(with("positive", "down"), "holds depths, positive downwards");
    refuses(with("standard_name", "sea_floor_depth_below_geoid"), "holds depths");
}

TEST_F(RasterFormats, TheHeightGridOfSeveralIsFoundOrAskedFor) {
    RasterFile two = hills();
    two.bands = 2;
    const auto named = [&](const std::string& name, const char* first, const char* second) {
        return write_as("netCDF", two, folder_.file(name), {}, [=](GDALDataset& d) {
            d.GetRasterBand(1)->SetMetadataItem("NETCDF_VARNAME", first);
            d.GetRasterBand(2)->SetMetadataItem("NETCDF_VARNAME", second);
        });
    };
    const std::string clear = named("clear.nc", "elevation", "land_cover");
    expect_heights(load_rasters({clear}, {}), two, 0);
    const std::string unclear = named("unclear.nc", "first", "second");
    refuses(unclear, "which of them is the height is not clear; name one of NETCDF:");
    expect_heights(load_rasters({"NETCDF:\"" + unclear + "\":first1"}, {}), two, 0);
}

TEST_F(RasterFormats, BinaryTerrainWithoutItsProjectionFileIsRefused) {
    RasterFile utm = hills();
    utm.crs = "EPSG:32632";
    utm.transform = {558000, 30, 0, 5186000, 0, -30};
    const std::string path = write_as("BT", utm, folder_.file("a.bt"));
    const Raster with_file = load_rasters({path}, {});
    VSIUnlink(folder_.file("a.prj").c_str());
    refuses(path, "a.prj, which is missing; put it there or give the system with --crs");
    RasterOptions options;
    options.crs = "EPSG:32632";
    EXPECT_NEAR(load_rasters({path}, options).north_deg, 46.8, 0.05);
    EXPECT_EQ(load_rasters({path}, options).columns, with_file.columns);
}

/// A PNG whose colours hold hills_m.
std::string write_colors(const std::string& path, HeightEncoding encoding, int bands, const char* driver = "PNG") {
    const RasterFile place = hills();
    GDALAllRegister();
    const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> memory(
        GetGDALDriverManager()->GetDriverByName("MEM")->Create("", place.columns, place.rows, bands, GDT_Byte, nullptr));
    const GDALColorInterp meanings[] = {GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand};
    for (int b = 0; b < bands; ++b) memory->GetRasterBand(b + 1)->SetColorInterpretation(meanings[b]);
    for (int j = 0; j < place.rows; ++j) {
        for (int i = 0; i < place.columns; ++i) {
            const bool is_void = hills_m(i, j) == kVoid;
            const double height_m = is_void ? 700 : hills_m(i, j);
            const auto code =
                static_cast<std::uint32_t>(encoding == HeightEncoding::terrarium ? std::lround((height_m + 32768) * 256)
                                                                                 : std::lround((height_m + 10000) * 10));
            std::uint8_t pixel[4] = {static_cast<std::uint8_t>(code >> 16), static_cast<std::uint8_t>(code >> 8),
                                     static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(is_void ? 0 : 255)};
            if (is_void && bands == 3) pixel[0] = pixel[1] = pixel[2] = 0;
            for (int b = 0; b < bands; ++b)
                EXPECT_EQ(memory->GetRasterBand(b + 1)->RasterIO(GF_Write, i, j, 1, 1, &pixel[b], 1, 1, GDT_Byte, 0, 0), CE_None);
        }
    }
    const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(
        GetGDALDriverManager()->GetDriverByName(driver)->CreateCopy(path.c_str(), memory.get(), FALSE, nullptr, nullptr,
                                                                    nullptr));
    EXPECT_NE(file, nullptr);
    return path;
}

TEST_F(RasterFormats, ColorsThatEncodeHeightsAreDecodedBeforeAnythingElse) {
    RasterOptions options;
    options.extent = MapExtent{9.6, 47.1 - 30.0 / 1200, 9.6 + 40.0 / 1200, 47.1};
    for (const int bands : {3, 4}) {
        options.encoding = HeightEncoding::terrain_rgb;
        const std::string rgb = write_colors(folder_.file("rgb.png"), *options.encoding, bands);
        const Raster read = load_rasters({rgb}, options);
        expect_heights(read, hills(), 0.05);
        EXPECT_THAT(read.notes, IsEmpty());
        EXPECT_EQ(sea_posts(read), 3);
        options.encoding = HeightEncoding::terrarium;
        expect_heights(load_rasters({write_colors(folder_.file("t.png"), *options.encoding, bands)}, options), hills(),
                       1.0 / 256);
    }
}

TEST_F(RasterFormats, AWorldFilePlacesAPictureAndMapUnitsAreThoseOfTheSystem) {
    RasterOptions options;
    options.encoding = HeightEncoding::terrain_rgb;
    const std::string path = write_colors(folder_.file("w.png"), *options.encoding, 3);
    folder_.write("w.pgw", "0.000833333333333333\n0\n0\n-0.000833333333333333\n9.60041666666667\n47.0995833333333\n");
    refuses(path, "names no coordinate system; give it with --crs", options);
    options.crs = "EPSG:4326";
    expect_heights(load_rasters({path}, options), hills(), 0.05);
    const std::string tile = write_colors(folder_.file("tile.png"), *options.encoding, 3);
    options.crs = "EPSG:3857";
    options.extent = MapExtent{1100000, 5900000, 1104000, 5903000};
    const Raster mercator = load_rasters({tile}, options);
    EXPECT_NEAR(mercator.west_deg, 1100050 / 6378137.0 * 57.29577951, 1e-3);
    for (const float height_m : mercator.height_m) {
        ASSERT_FALSE(height_m > 2700) << "interpolated in metres, not in colours";
    }
}

TEST_F(RasterFormats, ColorsWithoutAWordOrWithLossAreRefused) {
    RasterOptions options;
    options.extent = MapExtent{9, 46, 10, 47};
    refuses(write_colors(folder_.file("p.png"), HeightEncoding::terrain_rgb, 3),
            "holds colours or complex numbers, no heights; give a height raster, or say with --encoding", options);
    options.encoding = HeightEncoding::terrain_rgb;
    refuses(write_colors(folder_.file("p.jpg"), HeightEncoding::terrain_rgb, 3, "JPEG"), "compressed with loss", options);
    options.extent.reset();
    refuses(write_as("GTiff", hills(), folder_.file("a.tif")), "has no three bands of 8 bits", options);
}

TEST_F(RasterFormats, WhatCannotBeReadIsSaidInOneSentence) {
    refuses(folder_.write("a.mmf", "MMF"), "a.mmf: MMF files cannot be read, because no public description of the format exists");
    refuses(folder_.file("none.zip"), "none.zip: no such file");
    refuses(folder_.write("half.hf2", folder_.read("none")), "half.hf2: not a raster that GDAL can read");
    const std::string asc = write_as("AAIGrid", hills(), folder_.file("bare.asc"));
    VSIUnlink(folder_.file("bare.prj").c_str());
    refuses(asc, "bare.asc: the raster names no coordinate system; give it with --crs");
    RasterOptions options;
    options.crs = "EPSG:4326";
    expect_heights(load_rasters({asc}, options), hills(), 0.005);
}

/// A virtual raster of one part.
std::string virtual_raster(const std::string& part) {
    return R"(<VRTDataset rasterXSize="40" rasterYSize="30"><VRTRasterBand dataType="Float32" band="1"><SimpleSource>)"
           R"(<SourceFilename relativeToVRT="1">)" +
           part + "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
}

TEST_F(RasterFormats, FilesOfARasterAreAllThatIsReadWithIt) {
    const std::string tile = write_as("GTiff", hills(), folder_.file("t.tif"));
    EXPECT_THAT(files_of_raster(tile), ElementsAre(tile));
    for (const char* name : {"t.tif.aux.xml", "t.tif.msk", "t.tif.ovr"}) folder_.write(name, "");
    folder_.write("t.tif.txt", "");  // control: nobody reads it
    EXPECT_THAT(files_of_raster(tile), ElementsAre(tile, tile + ".aux.xml", tile + ".msk", tile + ".ovr"));
    const std::string mosaic = folder_.write("m.vrt", virtual_raster("t.tif"));
    EXPECT_THAT(files_of_raster(mosaic), ElementsAre(mosaic, tile, tile + ".aux.xml", tile + ".msk", tile + ".ovr"));
    const std::string outer = folder_.write("a.vrt", virtual_raster("m.vrt"));
    folder_.write("m.vrt.ovr", "");
    EXPECT_THAT(files_of_raster(outer),
                ElementsAre(outer, mosaic, mosaic + ".ovr", tile, tile + ".aux.xml", tile + ".msk", tile + ".ovr"));
}

TEST_F(RasterFormats, VirtualRastersThatNameEachOtherAreReadOnce) {
    const std::string name = std::filesystem::path(folder_.path()).filename().string();
    const std::string loop = folder_.write("l.vrt", virtual_raster("../" + name + "/l.vrt"));
    EXPECT_LE(files_of_raster(loop).size(), 3u);
}

TEST_F(RasterFormats, FilesOfARasterThatIsNotThereAreNamedNevertheless) {
    const std::string mosaic = folder_.write("m.vrt", virtual_raster("gone.tif"));
    EXPECT_THAT(files_of_raster(mosaic), ::testing::Contains(mosaic));
    EXPECT_THAT(files_of_raster(folder_.file("none.tif")), ElementsAre(folder_.file("none.tif")));
    EXPECT_THAT(files_of_raster(folder_.write("n.tif", "no raster")), ElementsAre(folder_.file("n.tif")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_raster_file
