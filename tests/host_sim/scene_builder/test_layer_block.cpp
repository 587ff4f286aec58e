#include "host_sim/scene_builder/layer_block.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim::test_layer_block {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

LayerRecipe parsed(const std::string& block) { return parse_scene("name = \"s\"\n" + block, "s.toml").layers.at(0); }

VariableLook variable(const std::string& name, const std::string& unit) {
    VariableLook look;
    look.name = name;
    look.unit = unit;
    look.places.columns = look.places.rows = 10;
    look.range = ValueRange{0, 1};
    return look;
}

/// By steps of the hydrostatic equation: 288.15 K at sea level, 6.5 K less per km up to 11 km, constant above.
double integrated_height_m(double pressure_hPa) {
    constexpr double kGravity = 9.80665, kGasOfAir = 287.05287, kStep_m = 0.5;
    double pressure = 1013.25, height_m = 0;
    while (pressure > pressure_hPa) {
        const double temperature_K = 288.15 - 0.0065 * std::min(height_m + kStep_m / 2, 11000.0);
        pressure *= std::exp(-kGravity * kStep_m / (kGasOfAir * temperature_K));
        height_m += kStep_m;
    }
    return height_m;
}

TEST(LayerBlock, NamesArePlain) {
    EXPECT_EQ(plain_name("OPERA 2024-11.dBZ", 31), "opera_2024_11_dbz");
    EXPECT_EQ(plain_name("var28 of table 228 of center ECMWF", 23), "var28_of_table_228_of_c");
    EXPECT_EQ(plain_name("\xC3\x84", 31), "unnamed");
}

TEST(LayerBlock, AWindHasItsHeightsFromTheGeopotential) {
    GridLook look;
    look.variables = {variable("z", "m**2 s**-2"), variable("u", "kt"), variable("v", "kt"), variable("t", "K")};
    for (VariableLook& one : look.variables) one.levels = {500, 850}, one.level_unit = "hPa";
    const std::string block = grid_block("era5.nc", "", look);
    const LayerRecipe layer = parsed(block);
    EXPECT_EQ(layer.role, scene::LayerRole::wind);
    EXPECT_EQ(layer.height_variable, "z");
    EXPECT_NEAR(layer.height_factor, 1 / 9.80665, 1e-9);
    ASSERT_EQ(layer.attributes.size(), 2u);
    EXPECT_EQ(layer.attributes[0].name, "east");
    EXPECT_NEAR(layer.attributes[0].factor, 1852.0 / 3600, 1e-6);
    EXPECT_EQ(layer.attributes[0].unit, "m/s");
    EXPECT_THAT(block, HasSubstr("each for another [[layer.attribute]]: z, t"));
}

TEST(LayerBlock, PressuresHaveStandardHeights) {
    GridLook look;
    look.variables = {variable("t", "C")};
    look.variables[0].levels = {200, 500, 850};
    look.variables[0].level_unit = "hPa";
    const LayerRecipe layer = parsed(grid_block("t.nc", "EPSG:2056", look));
    ASSERT_EQ(layer.heights_m.size(), 3u);
    for (std::size_t n = 0; n < 3; ++n) EXPECT_NEAR(layer.heights_m[n], integrated_height_m(look.variables[0].levels[n]), 2) << n;
    EXPECT_EQ(layer.attributes[0].offset, 273.15);
    EXPECT_EQ(layer.crs, "EPSG:2056");
}

TEST(LayerBlock, OneLevelIsKeptWhereHeightsAreUnknownOrTimesAreMissing) {
    GridLook look;
    look.variables = {variable("q", "")};
    look.variables[0].levels = {3, 7};
    EXPECT_THAT(parsed(grid_block("q.nc", "", look)).levels, ElementsAre(3));
    look.variables[0].level_unit = "hPa";
    look.variables[0].is_whole = false;
    look.variables[0].fullest_level = 7;
    EXPECT_THAT(parsed(grid_block("q.nc", "", look)).levels, ElementsAre(7));
}

TEST(LayerBlock, MembersGiveASpread) {
    GridLook look;
    look.variables = {variable("gust", "kt")};
    look.variables[0].least_members = look.variables[0].most_members = 51;
    look.variables[0].first_spread = 10;
    const LayerRecipe layer = parsed(grid_block("ens.grib", "", look));
    EXPECT_EQ(layer.members, "bands");
    EXPECT_TRUE(layer.attributes[0].uncertainty.is_spread);
    EXPECT_EQ(layer.attributes[0].uncertainty.full, 6) << "10 kt are 5.14 m/s";
}

TEST(LayerBlock, GridsThatAreTooLargeAreCut) {
    GridLook look;
    look.variables = {variable("t", "K")};
    look.variables[0].places.columns = 20000;
    look.variables[0].places.rows = 10000;
    look.variables[0].places.step_lon_deg = look.variables[0].places.step_lat_deg = 0.001;
    look.variables[0].places.north_deg = 50;
    look.variables[0].times_ns = {0, 3'600'000'000'000};
    const LayerRecipe layer = parsed(grid_block("t.tif", "", look));
    EXPECT_EQ(layer.until_ns, 0);
    ASSERT_TRUE(layer.prepare.region);
    EXPECT_NEAR(layer.prepare.region->east_deg - layer.prepare.region->west_deg, 1, 1e-6);
    EXPECT_NEAR(layer.prepare.region->north_deg, 45.5, 1e-6);
}

TEST(LayerBlock, TablesBindTheirColumns) {
    FeatureLook look;
    look.points = 2;
    ColumnLook lon, height, kind, seen, remark;
    lon.name = "longitude", lon.kind = ColumnKind::number, lon.stated = 2;
    height.name = "height_ft", height.kind = ColumnKind::number, height.stated = 2;
    kind.name = "kind", kind.texts = {"crane", "mast"}, kind.different_texts = 2, kind.stated = 2;
    seen.name = "seen", seen.kind = ColumnKind::time, seen.stated = 2;
    remark.name = "remark", remark.different_texts = 100, remark.stated = 100;
    look.columns = {lon, height, kind, seen, remark};
    const std::string block = feature_block("masts.csv", "", SourceKind::vector, look);
    const LayerRecipe layer = parsed(block);
    EXPECT_EQ(layer.time_variable, "seen");
    ASSERT_EQ(layer.attributes.size(), 2u);
    EXPECT_EQ(layer.attributes[0].name, "height");
    EXPECT_EQ(layer.attributes[0].variable, "height_ft");
    EXPECT_NEAR(layer.attributes[0].factor, 0.3048, 1e-12);
    EXPECT_THAT(layer.attributes[1].classes, ElementsAre("crane", "mast"));
    EXPECT_THAT(block, HasSubstr("Not used here: remark"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_layer_block
