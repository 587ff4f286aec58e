// Weather as it is published: ERA5 on pressure levels (netCDF), an ECMWF ensemble (GRIB 1), OPERA radar with its quality
// (GeoTIFF). What a scene makes of it is compared with what GDAL's own bands say.
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/scene_builder/grid_layer.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::test_weather {
namespace {

using host_sim::AttributeDraft;
using host_sim::AttributeRecipe;
using host_sim::LayerDraft;
using host_sim::LayerRecipe;

const std::string kFolder = test_support::real_data_dir() + "/weather";
constexpr std::int64_t kHour_ns = 3'600'000'000'000;
constexpr std::int64_t kJanuary2020_ns = 1'577'836'800'000'000'000;

AttributeRecipe attribute(const std::string& name, const std::string& variable) {
    AttributeRecipe recipe;
    recipe.name = name;
    recipe.variable = variable;
    return recipe;
}

TEST(Weather, Era5WindOnPressureLevels) {
    LayerRecipe recipe;
    recipe.name = "wind";
    recipe.source = "era5_davos_pressure_levels_202001.nc";
    recipe.from_ns = kJanuary2020_ns + 12 * kHour_ns;
    recipe.until_ns = kJanuary2020_ns + 14 * kHour_ns;
    recipe.height_variable = "z";
    recipe.height_factor = 1 / 9.80665;
    recipe.attributes = {attribute("east", "u"), attribute("north", "v")};
    const LayerDraft layer = make_grid_layer(recipe, kFolder).draft;
    EXPECT_EQ(layer.grid.columns, 5u);
    EXPECT_EQ(layer.grid.rows, 4u);
    ASSERT_EQ(layer.levels_m.size(), 6u);
    EXPECT_NEAR(layer.levels_m.front(), 200, 250) << "1000 hPa";
    EXPECT_NEAR(layer.levels_m.back(), 9200, 400) << "300 hPa";
    ASSERT_EQ(layer.times_ns.size(), 3u);
    EXPECT_EQ(layer.times_ns[0], *recipe.from_ns);
    EXPECT_EQ(layer.data_time_ns, *recipe.until_ns) << "a reanalysis is no forecast of its first hour";

    GDALAllRegister();
    const host_sim::GdalDataset u(
        GDALDataset::Open(("NETCDF:\"" + kFolder + "/" + recipe.source + "\":u").c_str(), GDAL_OF_RASTER));
    ASSERT_NE(u, nullptr);
    // Levels 300, 400, 500, 600, 700, 1000 hPa a time; 13 hours are 13 * 6 bands, and 500 hPa is the third.
    GDALRasterBand& band = *u->GetRasterBand(13 * 6 + 3);
    double stated = 0;
    ASSERT_EQ(band.RasterIO(GF_Read, 2, 1, 1, 1, &stated, 1, 1, GDT_Float64, 0, 0), CE_None);
    const double value = stated * band.GetScale() + band.GetOffset();
    const std::size_t level_500 = 3;  // from below: 1000, 700, 600, 500
    EXPECT_NEAR(double{layer.attributes[0].values[((1 * 6 + level_500) * 4 + 1) * 5 + 2]}, value, 1e-5);
}

TEST(Weather, EcmwfEnsembleAsMeanAndSpread) {
    LayerRecipe recipe;
    recipe.name = "gust";
    recipe.source = "ens_storm.grib";
    recipe.members = "bands";
    recipe.levels = {0};  // beside them stands one of 850 hPa
    recipe.attributes = {attribute("gust", "")};
    recipe.attributes[0].uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    recipe.attributes[0].uncertainty.is_spread = true;
    recipe.attributes[0].uncertainty.full = 10;
    const LayerDraft layer = make_grid_layer(recipe, kFolder).draft;
    ASSERT_EQ(layer.times_ns.size(), 3u);
    EXPECT_EQ(layer.times_ns[1] - layer.times_ns[0], 6 * kHour_ns);
    EXPECT_EQ(layer.data_time_ns, layer.times_ns[0] - 72 * kHour_ns) << "GRIB_FORECAST_SECONDS=259200 of the first";
    const AttributeDraft& gust = layer.attributes[0];

    const host_sim::GdalDataset file(GDALDataset::Open((kFolder + "/" + recipe.source).c_str(), GDAL_OF_RASTER));
    ASSERT_NE(file, nullptr);
    const int i = 20, j = 13;
    double sum = 0, squares = 0;
    int members = 0;
    for (int b = 1; b <= file->GetRasterCount(); ++b) {
        GDALRasterBand& band = *file->GetRasterBand(b);
        if (std::string(band.GetMetadataItem("GRIB_VALID_TIME")) != std::to_string(layer.times_ns[1] / 1'000'000'000) ||
            std::string(band.GetMetadataItem("GRIB_SHORT_NAME")) != "0-SFC")
            continue;
        double value = 0;
        ASSERT_EQ(band.RasterIO(GF_Read, i, j, 1, 1, &value, 1, 1, GDT_Float64, 0, 0), CE_None);
        sum += value;
        squares += value * value;
        ++members;
    }
    EXPECT_EQ(members, 51);
    const double mean = sum / members, spread = std::sqrt((squares - sum * mean) / (members - 1));
    const std::size_t post = (1 * 31 + j) * 48 + i;
    EXPECT_NEAR(double{gust.values[post]}, mean, 1e-4);
    EXPECT_NEAR(gust.uncertainties[post].level(), std::fmin(spread / 10, 1), 1.5 / 254);
    EXPECT_GT(spread, 0.3);
}

/// Of 51 members nine stay: by sums over the file's own bands, whose members come in one order at each time.
TEST(Weather, EcmwfEnsembleKeepsMembersFromTheLeastToTheGreatest) {
    LayerRecipe recipe;
    recipe.name = "gust";
    recipe.source = "ens_storm.grib";
    recipe.members = "bands";
    recipe.levels = {0};
    recipe.attributes = {attribute("gust", "")};
    recipe.keep_members = 9;
    const LayerDraft layer = make_grid_layer(recipe, kFolder).draft;
    const AttributeDraft& gust = layer.attributes[0];
    ASSERT_EQ(gust.members.size(), 9u);

    const host_sim::GdalDataset file(GDALDataset::Open((kFolder + "/" + recipe.source).c_str(), GDAL_OF_RASTER));
    ASSERT_NE(file, nullptr);
    std::vector<std::vector<float>> all(51);  // time by time
    for (const std::int64_t time_ns : layer.times_ns) {
        std::size_t member = 0;
        for (int b = 1; b <= file->GetRasterCount(); ++b) {
            GDALRasterBand& band = *file->GetRasterBand(b);
            if (std::string(band.GetMetadataItem("GRIB_VALID_TIME")) != std::to_string(time_ns / 1'000'000'000) ||
                std::string(band.GetMetadataItem("GRIB_SHORT_NAME")) != "0-SFC")
                continue;
            std::vector<float> values(48 * 31);
            ASSERT_EQ(band.RasterIO(GF_Read, 0, 0, 48, 31, values.data(), 48, 31, GDT_Float32, 0, 0), CE_None);
            ASSERT_LT(member, all.size());
            all[member].insert(all[member].end(), values.begin(), values.end());
            ++member;
        }
        EXPECT_EQ(member, 51u);
    }
    const auto sum = [](const std::vector<float>& member) { return std::accumulate(member.begin(), member.end(), 0.0); };
    std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return sum(a) < sum(b); });
    for (std::size_t n = 0; n < 9; ++n)
        EXPECT_EQ(gust.members[n], all[static_cast<std::size_t>(std::lround(static_cast<double>(n) * 50 / 8))]) << n;
}

TEST(Weather, OperaRadarWithItsQuality) {
    LayerRecipe recipe;
    recipe.name = "radar";
    recipe.source = "opera_20241126_0100_dbz_alps_0.01deg.tif";
    recipe.attributes = {attribute("reflectivity", "band 1")};
    AttributeRecipe& dbz = recipe.attributes[0];
    dbz.undetected = -8888000;
    dbz.undetected_value = -32;
    dbz.missing = {-9999000};
    dbz.uncertainty.kind = scene::UncertaintyKind::ordinal;
    dbz.uncertainty.source = "opera_20241126_0100_quality_alps_0.01deg.tif";
    dbz.uncertainty.variable = "band 1";
    dbz.uncertainty.is_quality = true;
    recipe.prepare.region = host_sim::RegionRecipe{9.5, 46.4, 10.3, 47.2};
    const LayerDraft layer = make_grid_layer(recipe, kFolder).draft;
    EXPECT_EQ(layer.data_time_ns, 1'732'582'800'000'000'000) << "2024-11-26 01:00";
    int known = 0, echoes = 0, sure = 0;
    const AttributeDraft& a = layer.attributes[0];
    for (std::size_t n = 0; n < a.values.size(); ++n) {
        known += std::isnan(a.values[n]) ? 0 : 1;
        echoes += a.values[n] > 0 ? 1 : 0;
        sure += a.uncertainties[n].is_known() && a.uncertainties[n].level() < 0.5 ? 1 : 0;
        EXPECT_FALSE(a.values[n] > 60 || a.values[n] < -33) << a.values[n];
    }
    EXPECT_GT(known, 3000);
    EXPECT_GT(echoes, 50);
    EXPECT_GT(sure, 500);
}

}  // namespace
}  // namespace tedavis::test_weather
