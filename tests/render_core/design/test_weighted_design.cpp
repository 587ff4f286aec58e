#include "render_core/design/weighted_design.hpp"

#include <gtest/gtest.h>

#include "render_core/design/color_difference.hpp"

namespace tedavis::design::test_weighted_design {
namespace {

AspectWeights weights_of(double terrain, double data, double uncertainty) {
    AspectWeights weights;
    weights.of[kTerrainAspect] = terrain;
    weights.of[kDataAspect] = data;
    weights.of[kUncertaintyAspect] = uncertainty;
    return weights;
}

/// All three aspects in full.
DesignSettings full_design() {
    DesignSettings design = default_design_settings();
    design.priority.is_stated = true;
    design.terrain.style.sketch.silhouettes = 0.8;
    GroundData& ground = design.data.ground;
    ground.is_shown = true;
    ground.scale.palette = alpine_palette();
    ground.uncertainty.technique = IntrinsicUncertainty::transparency;
    ground.overlay.technique = UncertaintyOverlay::fog;
    DataElement element;
    element.role = scene::LayerRole::wind;
    element.technique = DataTechnique::arrows;
    element.uncertainty = ElementUncertainty::tetrahedra;
    static_cast<void>(design.data.elements.try_push_back(element));
    return design;
}

DesignSettings weighed(const AspectWeights& weights) {
    DesignSettings design = full_design();
    apply_priorities(weights, design);
    return design;
}

/// Table 5.1.
TEST(WeightedDesign, TheThreePrioritiesOfTheThesis) {
    const DesignSettings terrain = weighed(weights_of(1, 0.3, 0.3)), data = weighed(weights_of(0, 1, 0.3)),
                         uncertainty = weighed(weights_of(0, 0.3, 1));
    EXPECT_EQ(terrain.terrain.style.shade.technique, TerrainShade::lambert);
    EXPECT_EQ(data.terrain.style.shade.technique, TerrainShade::none);
    EXPECT_EQ(uncertainty.terrain.style.shade.technique, TerrainShade::none);
    EXPECT_GT(data.terrain.style.sketch.silhouettes, 0);
    EXPECT_FALSE(terrain.data.ground.scale.breaks.empty()) << "segmented";
    EXPECT_TRUE(data.data.ground.scale.breaks.empty()) << "continuous";
    EXPECT_FALSE(uncertainty.data.ground.scale.breaks.empty());
    EXPECT_EQ(terrain.data.ground.overlay.technique, UncertaintyOverlay::none) << "intrinsic";
    EXPECT_EQ(uncertainty.data.ground.overlay.technique, UncertaintyOverlay::fog) << "extrinsic";
    EXPECT_EQ(terrain.data.elements[0].uncertainty, ElementUncertainty::transparency);
    EXPECT_EQ(uncertainty.data.elements[0].uncertainty, ElementUncertainty::tetrahedra);
    EXPECT_LT(terrain.data.elements[0].detail, data.data.elements[0].detail);
}

TEST(WeightedDesign, WhatIsNotStatedIsAsTheDesignSays) {
    DesignSettings design = full_design();
    design.priority.is_stated = false;
    apply_priorities(weights_of(0, 0, 0), design);
    EXPECT_EQ(design.terrain.style.shade.technique, TerrainShade::lambert);
    EXPECT_EQ(design.data.elements[0].detail, 1);
}

TEST(WeightedDesign, MoreWeightNeverConveysLess) {
    for (double weight = 0; weight < 1; weight += 0.05) {
        const DesignSettings less = weighed(weights_of(weight, 1, 1)), more = weighed(weights_of(weight + 0.05, 1, 1));
        const auto strength = [](const DesignSettings& design) {
            const ShadeSettings& shade = design.terrain.style.shade;
            return shade.technique == TerrainShade::none ? 0 : 1 - shade.ambient;
        };
        EXPECT_LE(strength(less), strength(more) + 1e-12) << weight;
        const DesignSettings fewer = weighed(weights_of(0, weight, 0)), finer = weighed(weights_of(0, weight + 0.05, 0));
        EXPECT_LE(detail_of(fewer.data.ground.scale), detail_of(finer.data.ground.scale)) << weight;
        EXPECT_LE(fewer.data.elements[0].detail, finer.data.elements[0].detail);
    }
}

/// What is unsure is never shown as sure.
TEST(WeightedDesign, TwoGradationsOfUncertaintyAlwaysStay) {
    for (const double terrain : {0.0, 0.5, 1.0})
        for (const double uncertainty : {0.0, 0.1, 1.0}) {
            const DesignSettings design = weighed(weights_of(terrain, 1, uncertainty));
            EXPECT_GE(detail_of(design.data.ground.uncertainty), 0.25);
            EXPECT_NE(design.data.elements[0].uncertainty, ElementUncertainty::none);
            EXPECT_NE(design.data.elements[0].uncertainty_levels, 1u);
        }
}

TEST(WeightedDesign, ShadingFallsWhereContinuousColorsMustBeRead) {
    const DesignSettings both = weighed(weights_of(0.9, 1, 0.5));
    EXPECT_GE(both.terrain.style.shade.ambient, 1 - 0.65 * 0.5 - 1e-12);
    DesignSettings without = full_design();
    without.data.ground.is_shown = false;
    apply_priorities(weights_of(0.9, 1, 0.5), without);
    EXPECT_LT(without.terrain.style.shade.ambient, both.terrain.style.shade.ambient) << "control";
}

double least_of_neighbours(const DataScale& scale, double light) {
    double least = 1e9;
    const auto seen = [&](std::size_t number) {
        const Color color = color_of_class(scale, number);
        return lab_of(
            linear_rgb({static_cast<std::uint8_t>(color.red * light + 0.5), static_cast<std::uint8_t>(color.green * light + 0.5),
                        static_cast<std::uint8_t>(color.blue * light + 0.5)}));
    };
    for (std::size_t n = 0; n < scale.breaks.size(); ++n) least = std::min(least, color_difference(seen(n), seen(n + 1)));
    return least;
}

TEST(WeightedDesign, ClassesKeepTheirDifferenceInTheDarkestShade) {
    DataScale scale;
    scale.palette = alpine_palette();
    reduce_classes(scale, 8);
    ShadeSettings shade;
    shade.ambient = 0.05;
    const double stated = 0.6 * least_of_neighbours(scale, 1);
    const double ambient = legible_ambient(shade, scale, stated);
    ASSERT_LT(least_of_neighbours(scale, shade.ambient), stated) << "too dark as it was";
    EXPECT_GE(least_of_neighbours(scale, ambient), 0.97 * stated);
    EXPECT_LT(least_of_neighbours(scale, ambient - 0.05), 1.03 * stated) << "no lighter than needed";
    EXPECT_EQ(legible_ambient(shade, scale, 2 * least_of_neighbours(scale, 1)), 1) << "never";
    EXPECT_EQ(legible_ambient(shade, scale, 0), shade.ambient);
    scale.breaks.clear();
    EXPECT_EQ(legible_ambient(shade, scale, 30), shade.ambient) << "no neighbours";
}

/// What hazards and stale data make of the weights is any mixture.
TEST(WeightedDesign, AtAnyWeightsThereAreTheProgramsOfTheDesignAsItWasRead) {
    for (const bool is_colored : {false, true}) {
        DesignSettings full = full_design();
        full.priority.shading.knots.clear();
        static_cast<void>(full.priority.shading.knots.try_push_back({0.3, 0}));
        static_cast<void>(full.priority.shading.knots.try_push_back({0.8, 1}));
        if (is_colored) full.terrain.style.shade.ambient_color = {0xFF, 0xF8, 0xF0};
        for (int n = 0; n < 11 * 11 * 11; ++n) {
            const AspectWeights weights = weights_of(0.1 * (n % 11), 0.1 * (n / 11 % 11), 0.1 * (n / 121));
            DesignSettings design = full;
            apply_priorities(weights, design);
            keep_programs(full, design);
            ASSERT_TRUE(same_programs(design.terrain.style, full.terrain.style)) << n << is_colored;
            ASSERT_TRUE(same_programs(design.data, full.data)) << n;
        }
    }
    EXPECT_FALSE(same_programs(weighed(weights_of(0, 0, 0)).terrain.style, full_design().terrain.style)) << "control";
}

TEST(WeightedDesign, AnOverlayThatAloneSaysHowUnsureDataAreStays) {
    DesignSettings design = full_design();
    design.data.ground.uncertainty.technique = IntrinsicUncertainty::none;
    apply_priorities(weights_of(1, 0.3, 0), design);
    EXPECT_EQ(design.data.ground.overlay.technique, UncertaintyOverlay::fog);
    EXPECT_GE(detail_of(design.data.ground.overlay), 0.25);
}

}  // namespace
}  // namespace tedavis::design::test_weighted_design
