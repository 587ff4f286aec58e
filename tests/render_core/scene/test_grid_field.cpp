#include "render_core/scene/grid_field.hpp"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <gdalwarper.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <random>

#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::scene::test_grid_field {
namespace {

using base::radians;

/// One layer, loaded.
struct Field {
    explicit Field(const host_sim::LayerDraft& draft) {
        host_sim::SceneDraft whole;
        whole.layers = {draft};
        test_support::FlakyBytes source(host_sim::sdb_bytes(whole));
        base::Arena arena(memory.data(), memory.size());
        scene = Scene::load(source, arena).value();
        field.emplace(scene.layers()[0], scene.layers()[0].attributes[0]);
    }
    [[nodiscard]] FieldValue at(double latitude_deg, double longitude_deg, double height_m, double hours) const {
        return field->at(radians(latitude_deg), radians(longitude_deg), height_m, static_cast<std::int64_t>(hours * 3.6e12));
    }

    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(1 << 20);
    Scene scene;
    std::optional<GridField> field;
};

/// Linear in all four coordinates.
host_sim::LayerDraft ramp() {
    host_sim::LayerDraft layer = test_support::small_grid();
    host_sim::AttributeDraft& a = layer.attributes[0];
    std::size_t n = 0;
    for (int t = 0; t < 2; ++t)
        for (int z = 0; z < 2; ++z)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 4; ++i, ++n) {
                    a.values[n] = static_cast<float>(10 * i - 7 * j + 100 * z + 1000 * t);
                    a.uncertainties[n] = Uncertainty::from_level(0.1 * i + 0.05 * j);
                    a.states[n] = ValueState::valid;
                }
    return layer;
}

TEST(GridField, PostsHaveTheirValues) {
    const Field field(ramp());
    for (int t = 0; t < 2; ++t)
        for (int z = 0; z < 2; ++z)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 4; ++i) {
                    const FieldValue found = field.at(47 - 0.5 * j, 9 + 0.25 * i, 1000 + 2000.0 * z, t);
                    EXPECT_EQ(found.state, ValueState::valid) << i << " " << j;
                    EXPECT_NEAR(found.value, 10 * i - 7 * j + 100 * z + 1000 * t, 1e-6);
                }
}

TEST(GridField, LinearFieldsAreExactBetweenPosts) {
    const Field field(ramp());
    std::mt19937 random(8);
    std::uniform_real_distribution<double> any(0, 1);
    for (int n = 0; n < 2000; ++n) {
        const double i = 3 * any(random), j = 2 * any(random), z = any(random), t = any(random);
        const FieldValue found = field.at(47 - 0.5 * j, 9 + 0.25 * i, 1000 + 2000 * z, t);
        EXPECT_NEAR(found.value, 10 * i - 7 * j + 100 * z + 1000 * t, 1e-4);
        EXPECT_NEAR(found.uncertainty.level(), 0.1 * i + 0.05 * j, 2.0 / 254);
    }
}

TEST(GridField, NothingIsExtrapolatedInSpace) {
    const Field field(ramp());
    EXPECT_EQ(field.at(47.01, 9.1, 1000, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(45.99, 9.1, 1000, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(46.5, 8.99, 1000, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(46.5, 9.76, 1000, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(46.5, 9.1, 999, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(46.5, 9.1, 3001, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(46.5, 9.1, std::nan(""), 0).state, ValueState::missing);
    EXPECT_EQ(field.at(std::nan(""), 9.1, 1000, 0).state, ValueState::missing);
    EXPECT_FALSE(field.at(47.01, 9.1, 1000, 0).uncertainty.is_known());
    EXPECT_EQ(field.at(46, 9.75, 3000, 1).state, ValueState::valid) << "the last corner";
}

TEST(GridField, BeforeAndAfterItsTimesTheNearestHoldsAndAges) {
    host_sim::LayerDraft draft = ramp();
    draft.attributes[0].uncertainty_growth_per_hour = 0.1;
    const Field field(draft);
    EXPECT_EQ(field.at(47, 9, 1000, 0.5).uncertainty.level(), 0) << "within its times it has no age";
    EXPECT_NEAR(field.at(47, 9, 1000, 3).value, 1000, 1e-6);
    EXPECT_NEAR(field.at(47, 9, 1000, 3).uncertainty.level(), 0.2, 1.0 / 254);
    EXPECT_NEAR(field.at(47, 9, 1000, -4).value, 0, 1e-6);
    EXPECT_NEAR(field.at(47, 9, 1000, -4).uncertainty.level(), 0.4, 1.0 / 254);
}

TEST(GridField, WithoutTimesItIsAsOldAsTheLayer) {
    host_sim::LayerDraft draft = test_support::small_grid();
    draft.grid.times = 1;
    draft.times_ns.clear();
    host_sim::AttributeDraft& a = draft.attributes[0];
    a.values.assign(24, 5);
    a.states.clear();
    a.uncertainties.clear();
    a.uncertainty_all = Uncertainty::from_level(0.25);
    a.uncertainty_growth_per_hour = 0.5;
    EXPECT_NEAR(Field(draft).at(46.5, 9.3, 2000, 10).uncertainty.level(), 0.25, 1.0 / 254) << "no time is stated";
    draft.data_time_ns = 0;
    EXPECT_NEAR(Field(draft).at(46.5, 9.3, 2000, 1).uncertainty.level(), 0.75, 1.0 / 254);
}

TEST(GridField, WhatIsMissingOrInterpolatedStaysSo) {
    const Field field(test_support::small_grid());  // post 5 (column 1, row 1) is missing, post 7 (column 3, row 1) interpolated
    EXPECT_EQ(field.at(46.5, 9.25, 1000, 0).state, ValueState::missing);
    EXPECT_EQ(field.at(46.6, 9.2, 1000, 0).state, ValueState::missing) << "a neighbour with weight";
    EXPECT_EQ(field.at(47, 9.2, 1000, 0).state, ValueState::valid) << "none has weight on this side";
    EXPECT_EQ(field.at(46.5, 9.75, 1000, 0).state, ValueState::interpolated);
    EXPECT_EQ(field.at(46.7, 9.7, 1000, 0).state, ValueState::interpolated);
}

TEST(GridField, ClassesAreNeverBlended) {
    host_sim::LayerDraft draft = ramp();
    host_sim::AttributeDraft& a = draft.attributes[0];
    a.scale = AttributeScale::nominal;
    a.classes = {"water", "wood", "rock", "ice"};
    for (std::size_t n = 0; n < a.values.size(); ++n) a.values[n] = static_cast<float>(n % 4);
    const Field field(draft);
    for (double i = 0; i <= 3; i += 0.07) {
        const double value = field.at(47, 9 + 0.25 * i, 1000, 0).value;
        EXPECT_EQ(value, std::floor(i + 0.5)) << i;
    }
}

TEST(GridField, RoundTheEarthTheGridHasNoEnd) {
    for (const bool repeats_first : {false, true}) {
        host_sim::LayerDraft draft;
        draft.name = "round";
        draft.shape = LayerShape::grid;
        draft.grid = {-base::kPi, 0.5 * base::kPi, radians(10), radians(90), repeats_first ? 37u : 36u, 3, 1, 1};
        host_sim::AttributeDraft a;
        a.name = "cosine";
        for (unsigned j = 0; j < 3; ++j)
            for (unsigned i = 0; i < draft.grid.columns; ++i) a.values.push_back(static_cast<float>(std::cos(radians(10.0 * i))));
        draft.attributes = {a};
        const Field field(draft);
        for (const double longitude : {-180.0, 180.0, 179.999, 175.0, -175.0, 540.0, 0.0}) {
            const FieldValue found = field.at(10, longitude, 0, 0);
            ASSERT_NE(found.state, ValueState::missing) << longitude;
            EXPECT_NEAR(found.value, std::cos(radians(longitude + 180)), 0.004) << longitude;
        }
    }
}

TEST(GridField, OverTheAntimeridianAsAnywhere) {
    host_sim::LayerDraft here = ramp(), there = ramp();
    there.grid.west_rad = radians(179.7);
    const Field a(here), b(there);
    for (double i = 0; i <= 3; i += 0.11) {
        const FieldValue x = a.at(46.6, 9 + 0.25 * i, 2000, 0.3),
                         y = b.at(46.6, 179.7 + 0.25 * i - (i > 1.2 ? 360 : 0), 2000, 0.3);
        EXPECT_EQ(x.state, y.state) << i;
        EXPECT_NEAR(x.value, y.value, 1e-4) << i;
    }
}

/// GDAL's bilinear warp of the same values to a grid four times as fine.
TEST(GridField, AsGdalInterpolates) {
    constexpr int kSide = 12, kFiner = 4;
    host_sim::LayerDraft draft;
    draft.name = "noise";
    draft.shape = LayerShape::grid;
    draft.grid = {radians(9), radians(47), radians(0.01), radians(0.01), kSide, kSide, 1, 1};
    host_sim::AttributeDraft a;
    a.name = "noise";
    std::mt19937 random(4);
    for (int n = 0; n < kSide * kSide; ++n) a.values.push_back(static_cast<float>(random() % 1000) / 10.0F);
    draft.attributes = {a};
    const Field field(draft);

    GDALAllRegister();
    GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
    ASSERT_NE(memory, nullptr);
    const auto close = [](GDALDataset* d) { GDALClose(d); };
    const std::unique_ptr<GDALDataset, decltype(close)> from(memory->Create("", kSide, kSide, 1, GDT_Float32, nullptr), close),
        to(memory->Create("", kSide * kFiner, kSide * kFiner, 1, GDT_Float32, nullptr), close);
    double coarse[6] = {9 - 0.005, 0.01, 0, 47 + 0.005, 0, -0.01}, fine[6] = {9 - 0.005, 0.0025, 0, 47 + 0.005, 0, -0.0025};
    from->SetGeoTransform(coarse);
    to->SetGeoTransform(fine);
    std::vector<float> values = a.values, warped(kSide * kFiner * kSide * kFiner);
    ASSERT_EQ(from->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, kSide, kSide, values.data(), kSide, kSide, GDT_Float32, 0, 0),
              CE_None);
    ASSERT_EQ(GDALReprojectImage(from.get(), nullptr, to.get(), nullptr, GRA_Bilinear, 0, 0, nullptr, nullptr, nullptr), CE_None);
    ASSERT_EQ(to->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, kSide * kFiner, kSide * kFiner, warped.data(), kSide * kFiner,
                                             kSide * kFiner, GDT_Float32, 0, 0),
              CE_None);
    int compared = 0;
    for (int j = kFiner; j < (kSide - 1) * kFiner; ++j)
        for (int i = kFiner; i < (kSide - 1) * kFiner; ++i, ++compared) {
            const double longitude = fine[0] + (i + 0.5) * fine[1], latitude = fine[3] + (j + 0.5) * fine[5];
            EXPECT_NEAR(field.at(latitude, longitude, 0, 0).value,
                        double{warped[static_cast<std::size_t>(j * kSide * kFiner + i)]}, 2e-3);
        }
    EXPECT_EQ(compared, 1600);
}

}  // namespace
}  // namespace tedavis::scene::test_grid_field
