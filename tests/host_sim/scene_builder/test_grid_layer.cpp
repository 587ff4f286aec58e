#include "host_sim/scene_builder/grid_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"
#include "tests/host_sim/scene_builder/netcdf_file.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_grid_layer {
namespace {

using test_support::expect_user_error;
using test_support::RasterFile;

class GridLayerOfFiles : public ::testing::Test {
protected:
    GridLayerOfFiles() {
        recipe_.name = "field";
        recipe_.source = "grid.tif";
        recipe_.attributes.resize(1);
        recipe_.attributes[0].name = "value";
        recipe_.attributes[0].variable = "band 1";
    }
    LayerDraft make() { return make_grid_layer(recipe_, folder_.path()).draft; }
    void write(const RasterFile& raster, const std::string& name = "grid.tif") {
        (void)raster.write(folder_.path() + "/" + name);
    }

    LayerRecipe recipe_;
    test_support::TemporaryFolder folder_;
};

TEST_F(GridLayerOfFiles, ValuesLieWhereTheFileHasThem) {
    write({});
    const LayerDraft layer = make();
    EXPECT_EQ(layer.shape, scene::LayerShape::grid);
    EXPECT_EQ(layer.grid.columns, 20u);
    EXPECT_NEAR(base::degrees(layer.grid.west_rad), 9.605, 1e-9);
    ASSERT_EQ(layer.attributes[0].values.size(), 300u);
    EXPECT_EQ(layer.attributes[0].values[20 + 3], 1000 + 21 + 3);
    EXPECT_FALSE(layer.attributes[0].uncertainties[0].is_known()) << "nothing is said of it";
    EXPECT_TRUE(layer.levels_m.empty());
    EXPECT_TRUE(layer.times_ns.empty());
}

TEST_F(GridLayerOfFiles, ASystemThatIsTakenForGrantedIsSaid) {
    RasterFile raster;
    write(raster);
    EXPECT_TRUE(make_grid_layer(recipe_, folder_.path()).notes.empty());
    raster.crs = "";
    write(raster);
    const std::vector<std::string> notes = make_grid_layer(recipe_, folder_.path()).notes;
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0],
              "field: grid.tif states no reference system and is taken for longitude and latitude; 'crs' names another");
    recipe_.crs = "EPSG:4326";
    EXPECT_TRUE(make_grid_layer(recipe_, folder_.path()).notes.empty());
}

TEST_F(GridLayerOfFiles, AVariableWithoutValuesIsSaid) {
    RasterFile raster;
    raster.value = [](int, int) { return std::nan(""); };
    write(raster);
    const std::vector<std::string> notes = make_grid_layer(recipe_, folder_.path()).notes;
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0], "field: 'band 1' has no values; nothing but what is missing is shown");
}

TEST_F(GridLayerOfFiles, ARegionIsCutOut) {
    write({});
    recipe_.prepare.region = RegionRecipe{9.652, 46.98, 9.68, 47.02};
    const LayerDraft layer = make();
    EXPECT_NEAR(base::degrees(layer.grid.west_rad), 9.645, 1e-9);
    EXPECT_EQ(layer.grid.columns, 5u);
    EXPECT_EQ(layer.attributes[0].values[0], 1000 + 7 * 4 + 3 * 7);
    recipe_.prepare.region = RegionRecipe{0, 0, 1, 1};
    expect_user_error([this] { (void)make(); }, "has nothing in the region");
}

TEST_F(GridLayerOfFiles, UncertaintyComesFromANumberAVariableOrAnotherFile) {
    RasterFile raster;
    raster.bands = 2;
    write(raster);
    UncertaintyRecipe& unsure = recipe_.attributes[0].uncertainty;
    unsure.kind = scene::UncertaintyKind::standard_deviation;
    unsure.value = 2;
    unsure.full = 8;
    EXPECT_NEAR(make().attributes[0].uncertainties[7].level(), 0.25, 1.0 / 254);
    unsure.value.reset();
    unsure.variable = "band 2";
    unsure.full = 10000;
    EXPECT_NEAR(make().attributes[0].uncertainties[3].level(), 0.6021, 1.0 / 254);
    RasterFile quality;
    quality.value = [](int i, int) { return i / 20.0; };
    write(quality, "quality.tif");
    unsure.variable = "band 1";
    unsure.source = "quality.tif";
    unsure.full = 1;
    unsure.is_quality = true;
    EXPECT_NEAR(make().attributes[0].uncertainties[15].level(), 0.25, 1.0 / 254);
    quality.columns = 19;
    write(quality, "quality.tif");
    expect_user_error([this] { (void)make(); }, "lies on another grid");
}

TEST_F(GridLayerOfFiles, MembersBecomeMeanAndSpread) {
    RasterFile raster;
    raster.bands = 2;  // the second is 5000 more
    write(raster);
    recipe_.attributes[0].variable = "";
    expect_user_error([this] { (void)make(); }, "2 grids of one time and level");
    recipe_.members = "bands";
    recipe_.attributes[0].uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    recipe_.attributes[0].uncertainty.is_spread = true;
    recipe_.attributes[0].uncertainty.full = 10000;
    const LayerDraft layer = make();
    EXPECT_EQ(layer.attributes[0].values[0], 3500);
    EXPECT_NEAR(layer.attributes[0].uncertainties[0].level(), 5000 / std::sqrt(2) / 10000, 1.0 / 254) << "divided by n - 1";
    recipe_.attributes[0].factor = -0.5;
    EXPECT_NEAR(make().attributes[0].uncertainties[0].level(), 2500 / std::sqrt(2) / 10000, 1.0 / 254) << "in the values' unit";
}

TEST_F(GridLayerOfFiles, OneMemberHasNoSpread) {
    write({});
    recipe_.members = "bands";
    recipe_.attributes[0].uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    recipe_.attributes[0].uncertainty.is_spread = true;
    expect_user_error([this] { (void)make(); },
                      "grid.tif has one member at a time and level, and a spread is that of two or more");
    recipe_.members = "";
    expect_user_error([this] { (void)make(); }, "has one member at a time and level");
    recipe_.attributes[0].uncertainty.is_spread = false;
    EXPECT_FALSE(make().attributes[0].uncertainties[0].is_known()) << "a kind alone says no number";
    recipe_.attributes[0].uncertainty.value = 0;
    EXPECT_EQ(make().attributes[0].uncertainties[0].level(), 0) << "control: a stated 0 is one";
}

TEST_F(GridLayerOfFiles, AMemberThatStatesNoneHasNoPartInTheMean) {
    RasterFile raster;
    raster.bands = 2;
    raster.value = [](int i, int) { return i == 3 ? 40 : 50.0; };
    raster.second = [](int i, int) { return i == 3 ? -9999 : (i == 5 ? -8888 : 54.0); };
    raster.more = [](int) { return 0; };
    write(raster);
    recipe_.attributes[0].variable = "";
    recipe_.members = "bands";
    recipe_.attributes[0].missing = {-9999};
    recipe_.attributes[0].undetected = -8888;
    recipe_.attributes[0].undetected_value = 10;
    recipe_.attributes[0].uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    recipe_.attributes[0].uncertainty.is_spread = true;
    recipe_.attributes[0].uncertainty.full = 100;
    const AttributeDraft value = make().attributes[0];
    EXPECT_EQ(value.values[0], 52) << "control: of both";
    EXPECT_TRUE(std::isnan(value.values[3])) << "not the mean of 40 and -9999";
    EXPECT_FALSE(value.uncertainties[3].is_known());
    EXPECT_EQ(value.values[5], 30) << "nothing seen is a value";
    EXPECT_NEAR(value.uncertainties[5].level(), 40 / std::sqrt(2) / 100, 1.0 / 254);
    recipe_.attributes[0].uncertainty = {};
    recipe_.attributes[0].scale = scene::AttributeScale::nominal;
    recipe_.attributes[0].classes = {"a", "b", "c"};
    expect_user_error([this] { (void)make(); }, "classes have no mean");
}

/// A level of the uncertainty's own raster that means "unknown" stays so when rasters are warped, and no value is mixed with a
/// code.
TEST_F(GridLayerOfFiles, CodesAreNotMixedWithValuesWhereRastersAreWarped) {
    RasterFile raster;
    raster.crs = "EPSG:2056";
    raster.transform = {2780000, 1000, 0, 1190000, 0, -1000};
    raster.value = [](int i, int) { return i < 10 ? 50.0 : -9999; };
    write(raster);
    raster.value = [](int i, int) { return i < 10 ? 0.2 : 255; };
    write(raster, "quality.tif");
    UncertaintyRecipe& unsure = recipe_.attributes[0].uncertainty;
    unsure.kind = scene::UncertaintyKind::ordinal;
    unsure.source = "quality.tif";
    unsure.variable = "band 1";
    unsure.full = 100;
    recipe_.attributes[0].missing = {-9999};
    const AttributeDraft value = make().attributes[0];
    std::size_t known = 0, unknown = 0;
    for (std::size_t n = 0; n < value.values.size(); ++n) {
        EXPECT_TRUE(std::isnan(value.values[n]) || value.values[n] == 50) << n;
        EXPECT_TRUE(!value.uncertainties[n].is_known() || value.uncertainties[n].level() < 0.01) << n;
        known += value.uncertainties[n].is_known() ? 1 : 0;
        unknown += value.uncertainties[n].is_known() ? 0 : 1;
    }
    EXPECT_GT(known, 100u);
    EXPECT_GT(unknown, 100u);
}

/// Zero is what lies under a mask as a rule, and would be certain.
TEST_F(GridLayerOfFiles, WhatAMaskCoversIsUnknown) {
    write({});
    RasterFile sigma;
    sigma.value = [](int i, int) { return i == 3 ? 0 : 2; };
    const std::string path = sigma.write(folder_.file("sigma.tif"));
    UncertaintyRecipe& unsure = recipe_.attributes[0].uncertainty;
    unsure.kind = scene::UncertaintyKind::standard_deviation;
    unsure.source = "sigma.tif";
    unsure.variable = "band 1";
    unsure.full = 8;
    EXPECT_EQ(make().attributes[0].uncertainties[3].level(), 0) << "control: without a mask 0 is stated";
    test_support::mask_out(path, 3);
    const AttributeDraft value = make().attributes[0];
    EXPECT_FALSE(value.uncertainties[3].is_known());
    EXPECT_NEAR(value.uncertainties[4].level(), 0.25, 1.0 / 254);
}

/// Two bands of one file, of which the second, warped with the first, has no data where the first has.
TEST_F(GridLayerOfFiles, EachWarpedBandHasItsOwnMissingOnes) {
    RasterFile raster;
    raster.crs = "EPSG:2056";
    raster.transform = {2780000, 1000, 0, 1190000, 0, -1000};
    raster.bands = 2;
    raster.no_data = 0;
    raster.more = [](int) { return 0; };
    raster.value = [](int, int) { return 50; };
    raster.second = [](int i, int) { return i < 10 ? 2 : 0; };
    raster.scale = 2;
    write(raster);
    UncertaintyRecipe& unsure = recipe_.attributes[0].uncertainty;
    unsure.kind = scene::UncertaintyKind::standard_deviation;
    unsure.variable = "band 2";
    unsure.full = 8;
    const AttributeDraft value = make().attributes[0];
    std::size_t known = 0, unknown = 0;
    for (std::size_t n = 0; n < value.values.size(); ++n) {
        if (std::isnan(value.values[n])) continue;
        EXPECT_EQ(value.values[n], 100) << "scaled";
        EXPECT_TRUE(!value.uncertainties[n].is_known() || std::abs(value.uncertainties[n].level() - 0.5) < 1.0 / 254) << n;
        known += value.uncertainties[n].is_known() ? 1 : 0;
        unknown += value.uncertainties[n].is_known() ? 0 : 1;
    }
    EXPECT_GT(known, 100u);
    EXPECT_GT(unknown, 100u);
}

/// Hours since 1970 as a layer's time.
constexpr std::int64_t at_hour(int hour) { return std::int64_t{hour} * 3'600'000'000'000; }

TEST_F(GridLayerOfFiles, TimesAreThoseOfTheDataUnlessAForecastIsStated) {
    recipe_.source = "grid.nc";
    recipe_.attributes[0].variable = "u";
    const auto made = [this](const test_support::NetcdfFile& file) {
        std::remove(folder_.file("grid.nc").c_str());
        file.write(folder_.file("grid.nc"));
        return make();
    };
    const LayerDraft analyses = made({{24, 25, 720}, {}, {}, ""});
    EXPECT_EQ(analyses.times_ns, (std::vector<std::int64_t>{at_hour(24), at_hour(25), at_hour(720)}));
    EXPECT_EQ(analyses.data_time_ns, at_hour(720)) << "none of them is a forecast";
    EXPECT_EQ(made({{24, 25, 30}, {}, 18, ""}).data_time_ns, at_hour(18));
    EXPECT_EQ(made({{24}, {}, 18, ""}).data_time_ns, at_hour(24)) << "the age of one alone counts from when it holds";
    const LayerDraft steps = made({{18}, {0, 6, 12}, {}, "forecast_reference_time"});
    EXPECT_EQ(steps.times_ns, (std::vector<std::int64_t>{at_hour(18), at_hour(24), at_hour(30)}));
    EXPECT_EQ(steps.data_time_ns, at_hour(18));
    EXPECT_EQ(made({{}, {0, 6}, 18, ""}).times_ns, (std::vector<std::int64_t>{at_hour(18), at_hour(24)}));
    recipe_.data_time_ns = at_hour(20);
    EXPECT_EQ(made({{24, 25, 720}, {}, {}, ""}).data_time_ns, at_hour(20)) << "the scene file's own goes before";
}

TEST_F(GridLayerOfFiles, KeptMembersAreThoseOfTheFileByTheRankOfTheirMean) {
    RasterFile raster;
    raster.bands = 5;
    raster.more = [](int band) { return 5000.0 * (band - 1); };
    raster.no_data = -1;
    raster.value = [](int i, int j) { return i == 4 && j == 4 ? -1.0 : 40.0 + i; };
    write(raster);
    recipe_.attributes[0].variable = "";
    recipe_.attributes[0].factor = -2;  // so that ranks are of what the file states, whatever becomes of it
    recipe_.members = "bands";
    EXPECT_TRUE(make().attributes[0].members.empty()) << "none is kept that is not asked for";
    recipe_.keep_members = 3;
    const AttributeDraft value = make().attributes[0];
    ASSERT_EQ(value.members.size(), 3u);
    for (std::size_t post = 0; post < 300; ++post)
        for (std::size_t n = 0; n < 3; ++n) {
            const float member = value.members[n][post];
            if (post == 84)
                EXPECT_TRUE(std::isnan(member));
            else
                EXPECT_EQ(member, -2 * (40 + static_cast<float>(post % 20) + 10000 * static_cast<float>(n)));
        }
    recipe_.keep_members = 16;
    EXPECT_EQ(make().attributes[0].members.size(), 5u) << "all there are";
}

/// Filling gaps and smoothing are linear: the mean of prepared members is the prepared mean, and they share its states.
TEST_F(GridLayerOfFiles, KeptMembersArePreparedAsTheirMeanIs) {
    RasterFile raster;
    raster.bands = 4;
    raster.more = [](int band) { return 5000.0 * (band - 1); };
    raster.no_data = -1;
    raster.value = [](int i, int j) { return i == 4 && j == 4 ? -1.0 : 50.0 + 3 * i + (i * j) % 7; };
    write(raster);
    recipe_.attributes[0].variable = "";
    recipe_.members = "bands";
    recipe_.keep_members = 4;
    recipe_.prepare.fill_cells = 1;
    recipe_.prepare.smooth_cells = 1.5;
    const AttributeDraft value = make().attributes[0];
    for (std::size_t post = 0; post < 300; ++post) {
        double sum = 0;
        for (const std::vector<float>& member : value.members) sum += static_cast<double>(member[post]);
        EXPECT_NEAR(sum / 4, static_cast<double>(value.values[post]), 0.01) << post;
    }
    EXPECT_EQ(value.states[84], scene::ValueState::interpolated);
    // Negative control: what the recipe takes from a member alone is missing in all, and never filled in as if it were known.
    recipe_.attributes[0].most = 15'062;
    const AttributeDraft cut = make().attributes[0];
    EXPECT_FALSE(std::isnan(cut.values[0]));
    EXPECT_FALSE(std::isnan(cut.members[3][0]));
    EXPECT_TRUE(std::isnan(cut.values[10])) << "of the last member more than 15062";
    for (const std::vector<float>& member : cut.members) EXPECT_TRUE(std::isnan(member[10]));
}

TEST_F(GridLayerOfFiles, MissingOnesStayMissingUnlessGapsAreFilled) {
    RasterFile raster;
    raster.no_data = -1;
    raster.value = [](int i, int j) { return i == 4 && j == 4 ? -1.0 : 50.0; };
    write(raster);
    LayerDraft layer = make();
    EXPECT_TRUE(std::isnan(layer.attributes[0].values[84]));
    EXPECT_EQ(layer.attributes[0].states[84], scene::ValueState::missing);
    recipe_.prepare.fill_cells = 1;
    layer = make();
    EXPECT_EQ(layer.attributes[0].values[84], 50);
    EXPECT_EQ(layer.attributes[0].states[84], scene::ValueState::interpolated);
    recipe_.attributes[0].scale = scene::AttributeScale::nominal;
    recipe_.attributes[0].classes = std::vector<std::string>(16, "c");
    EXPECT_TRUE(std::isnan(make().attributes[0].values[84])) << "classes are never interpolated";
}

TEST_F(GridLayerOfFiles, WhatIsNotBoundIsSaid) {
    write({});
    recipe_.heights_m = {100, 200};
    expect_user_error([this] { (void)make(); }, "has 1 levels and 2 heights are given");
    recipe_.attributes.clear();
    expect_user_error([this] { (void)make(); }, "needs an [[layer.attribute]]");
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_layer
