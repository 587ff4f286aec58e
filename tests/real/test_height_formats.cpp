// The Davos area in other programs' formats is the same ground as the SRTM raster it was made from; a .bt of another
// program's making lies where its country is.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "host_sim/commands/check_raster.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::test_height_formats {
namespace {

using host_sim::load_rasters;
using host_sim::Raster;
using host_sim::RasterOptions;

const std::string kData = test_support::real_data_dir();
constexpr const char* kSrtm = "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif";

/// Bilinear, in a raster without voids.
double height_m(const Raster& raster, double longitude_deg, double latitude_deg) {
    const double x = (longitude_deg - raster.west_deg) / raster.step_lon_deg,
                 y = (raster.north_deg - latitude_deg) / raster.step_lat_deg;
    const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
    const double u = x - i, v = y - j;
    const auto h = [&](std::uint32_t a, std::uint32_t b) { return double{raster.height_m[raster.at(i + a, j + b)]}; };
    return (h(0, 0) * (1 - u) + h(1, 0) * u) * (1 - v) + (h(0, 1) * (1 - u) + h(1, 1) * u) * v;
}

struct Difference {
    double rms_m = 0, mean_m = 0;
    std::size_t posts = 0;
};

/// Of a raster, moved north by some degrees, against the SRTM raster.
Difference compare(const Raster& raster, double north_deg = 0) {
    static const Raster srtm = load_rasters({kData + kSrtm}, {});
    Difference d;
    for (std::uint32_t j = 3; j + 3 < raster.rows; j += 3) {
        for (std::uint32_t i = 3; i + 3 < raster.columns; i += 3) {
            const float here_m = raster.height_m[raster.at(i, j)];
            if (std::isnan(here_m)) continue;
            const double error_m = here_m - height_m(srtm, raster.west_deg + raster.step_lon_deg * i,
                                                     raster.north_deg - raster.step_lat_deg * j + north_deg);
            d.rms_m += error_m * error_m;
            d.mean_m += error_m;
            ++d.posts;
        }
    }
    d.rms_m = std::sqrt(d.rms_m / static_cast<double>(d.posts));
    d.mean_m /= static_cast<double>(d.posts);
    return d;
}

TEST(HeightFormats, TheHf2FileHoldsTheSrtmPosts) {
    const Raster raster = load_rasters({kData + "/formats/davos_1025.hf2"}, {});
    EXPECT_FALSE(raster.resampled);
    ASSERT_EQ(raster.columns, 1025u);
    const Difference same = compare(raster), moved = compare(raster, 0.01);
    EXPECT_LT(same.rms_m, 0.01);
    EXPECT_GT(moved.rms_m, 50) << "control: a shift shows";
}

TEST(HeightFormats, TheUtmFilesLieOnTheSameGround) {
    RasterOptions options;
    options.crs = "EPSG:32632";
    const Raster binary = load_rasters({kData + "/formats/davos_utm.bt"}, options);
    options.extent = host_sim::MapExtent{558468.471858957549557, 5185960.520823864266276 - 30.0 * 1063,
                                         558468.471858957549557 + 30.0 * 738, 5185960.520823864266276};
    options.void_value = -29786;  // what filled the corners, as it is stored: the format knows no voids
    const Raster terragen = load_rasters({kData + "/formats/davos_utm.ter"}, options);
    for (const Raster* raster : {&binary, &terragen}) {
        const Difference same = compare(*raster), moved = compare(*raster, 30 / 111120.0);
        EXPECT_GT(same.posts, 50'000u);
        EXPECT_LT(same.rms_m, 6) << "interpolated twice, and whole metres or 0.06 m";
        EXPECT_NEAR(same.mean_m, 0, 0.5);
        EXPECT_GT(moved.rms_m, same.rms_m * 1.5) << "control: one post further north is further off";
    }
    ASSERT_EQ(binary.columns, terragen.columns);
    ASSERT_EQ(binary.rows, terragen.rows);
    EXPECT_GT(binary.void_posts, 1000u) << "the corners of the turned area";
    EXPECT_EQ(binary.void_posts, terragen.void_posts);
    double largest_m = 0;
    for (std::size_t n = 0; n < binary.height_m.size(); ++n)
        if (!std::isnan(binary.height_m[n]))
            largest_m = std::max(largest_m, std::abs(double{binary.height_m[n]} - double{terragen.height_m[n]}));
    EXPECT_LT(largest_m, 0.07) << "0.0627 m is the step of the Terragen file";
}

TEST(HeightFormats, TheUtmFileIsRefusedWithoutItsProjectionFile) {
    test_support::expect_user_error([] { (void)load_rasters({kData + "/formats/davos_utm.bt"}, {}); },
                                    "davos_utm.prj, which is missing");
}

// Swisstopo's national map: the lake of Thun lies at 558 m, and the map sheet's corner coordinates are round.
TEST(HeightFormats, TheBinaryTerrainOfAnotherProgramLiesInItsValley) {
    const Raster raster = load_rasters({kData + "/formats/swisstopo_dhm25_interlaken_25m_350x240_lv03.bt"}, {});
    EXPECT_TRUE(raster.resampled);
    EXPECT_NEAR(raster.west_deg, 7.8146, 0.003);
    EXPECT_NEAR(raster.north_deg, 46.7357, 0.003);
    EXPECT_GT(raster.void_posts, 0u);
    float lowest = 1e9f, highest = 0;
    for (const float h : raster.height_m) {
        if (std::isnan(h)) continue;
        lowest = std::min(lowest, h);
        highest = std::max(highest, h);
    }
    EXPECT_NEAR(lowest, 558, 10);
    EXPECT_NEAR(highest, 2000, 100);
}

TEST(HeightFormats, TheSrtmTileInItsArchiveKeepsItsVoids) {
    const Raster raster = load_rasters({kData + "/terrain/N42E001_pyrenees_andorra_srtm3.hgt.zip"}, {});
    EXPECT_FALSE(raster.resampled);
    EXPECT_EQ(raster.void_posts, 7652u);
    EXPECT_EQ(raster.columns, 1201u);
    EXPECT_NEAR(raster.west_deg, 1, 1e-9);
    EXPECT_NEAR(raster.north_deg, 43, 1e-9);
    RasterOptions ellipsoid;
    ellipsoid.vertical_datum = host_sim::VerticalDatum::ellipsoid;
    test_support::expect_user_error(
        [&] { (void)load_rasters({kData + "/terrain/N42E001_pyrenees_andorra_srtm3.hgt.zip"}, ellipsoid); },
        "contradicts --vertical-datum");
}

TEST(HeightFormats, WeatherIsNotTerrain) {
    const std::string weather = kData + "/weather/era5_davos_pressure_levels_202001.nc";
    test_support::expect_user_error([&] { (void)load_rasters({weather}, {}); }, "which of them is the height is not clear");
    RasterOptions options;
    options.crs = "EPSG:4326";
    test_support::expect_user_error([&] { (void)load_rasters({"NETCDF:\"" + weather + "\":z"}, options); },
                                    "values are in 'm**2 s**-2', which is no length");
    for (const char* name : {"dbz", "quality"}) {
        const std::string radar = kData + "/weather/opera_20241126_0100_" + name + "_alps_0.01deg.tif";
        test_support::expect_user_error([&] { (void)load_rasters({radar}, {}); }, "says that it holds 'DBZH'");
    }
}

TEST(HeightFormats, GroundHasNoFindings) {
    for (const std::string& file :
         {kData + kSrtm, kData + "/terrain/N42E001_pyrenees_andorra_srtm3.hgt.zip", kData + "/formats/davos_1025.hf2",
          kData + "/formats/swisstopo_dhm25_interlaken_25m_350x240_lv03.bt"})
        for (const host_sim::Finding& finding : host_sim::check_raster(file).warnings) ADD_FAILURE() << finding.text;
}

}  // namespace
}  // namespace tedavis::test_height_formats
