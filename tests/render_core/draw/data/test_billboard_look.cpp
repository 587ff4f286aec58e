#include "render_core/draw/data/billboard_look.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_billboard_look {
namespace {

using design::ElementUncertainty;
using test_support::ElementOfTest;

constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// Three masts, certain, half sure and unknown.
host_sim::LayerDraft masts() {
    host_sim::LayerDraft layer = test_support::small_points();
    layer.data_time_ns = 100 * kHour_ns;
    host_sim::AttributeDraft& kind = layer.attributes[0];
    kind.uncertainty_kind = scene::UncertaintyKind::ordinal;
    kind.uncertainty_full = 1;
    kind.uncertainties = {scene::Uncertainty::from_code(0), scene::Uncertainty::from_code(127), scene::Uncertainty()};
    return layer;
}

TEST(BillboardLook, WithoutATechniqueColorsStay) {
    ElementOfTest test(masts());
    for (std::size_t n : {0, 1, 2}) {
        const BillboardLook look = billboard_look(test.input(), n);
        EXPECT_EQ(look.color, test.element.color);
        EXPECT_FALSE(look.is_unsure);
    }
    test.element.opacity = 0.5;
    EXPECT_EQ(billboard_look(test.input(), 0).color.alpha, 128);
    EXPECT_EQ(billboard_look(test.input(), 0).text.alpha, 128);
}

TEST(BillboardLook, WhatIsLessSureIsLessThere) {
    ElementOfTest test(masts());
    test.element.uncertainty = ElementUncertainty::transparency;
    test.element.uncertainty_strength = 0.8;
    EXPECT_EQ(billboard_look(test.input(), 0).color.alpha, 255);
    EXPECT_EQ(billboard_look(test.input(), 1).color.alpha, 153) << "255 (1 - 0.8 / 2)";
    EXPECT_EQ(billboard_look(test.input(), 2).color.alpha, 51) << "unknown is never taken for certain";
    EXPECT_TRUE(billboard_look(test.input(), 2).is_unsure);
    EXPECT_FALSE(billboard_look(test.input(), 1).is_unsure);
    test.element.uncertainty_levels = 2;
    EXPECT_EQ(billboard_look(test.input(), 1).color.alpha, 51) << "the upper one of two";
}

TEST(BillboardLook, AHazardNeverFades) {
    ElementOfTest test(masts());
    test.element.technique = design::DataTechnique::billboard;
    test.element.uncertainty_strength = 1;
    for (const auto uncertainty : {ElementUncertainty::transparency, ElementUncertainty::dashed_rim})
        for (std::size_t n : {0, 1, 2}) {
            test.element.uncertainty = uncertainty;
            const BillboardLook look = billboard_look(test.input(), n);
            const bool fades = uncertainty == ElementUncertainty::transparency && n > 0;
            EXPECT_EQ(look.color.alpha, fades ? 153 : 255) << "at least 0.6 of 255";
            EXPECT_EQ(look.text.alpha, 255);
        }
    test.element.technique = design::DataTechnique::diagram;
    test.element.uncertainty = ElementUncertainty::transparency;
    EXPECT_EQ(billboard_look(test.input(), 2).color.alpha, 0) << "what is no billboard may";
}

TEST(BillboardLook, TheRimIsTheMoreBrokenTheLessSure) {
    ElementOfTest test(masts());
    test.element.technique = design::DataTechnique::billboard;
    test.element.uncertainty = ElementUncertainty::dashed_rim;
    test.element.uncertainty_strength = 1;
    const auto rim = [&](std::size_t n) { return billboard_look(test.input(), n).rim(); };
    EXPECT_EQ(rim(0), 0) << "the certain has none";
    EXPECT_NEAR(rim(1), 1 - 0.5 * (1 - kMinDashes), 0.01);
    EXPECT_NEAR(rim(2), kMinDashes, 1e-6) << "unknown is never taken for certain";
    test.element.uncertainty = ElementUncertainty::transparency;
    EXPECT_EQ(rim(1), 0);
    EXPECT_EQ(rim(2), BillboardLook::kUnknownDashes);
    test.element.uncertainty = ElementUncertainty::none;
    EXPECT_EQ(rim(2), 0);
}

TEST(BillboardLook, WhatIsLessSureIsGreyer) {
    ElementOfTest test(masts());
    test.element.uncertainty = ElementUncertainty::saturation;
    test.element.uncertainty_strength = 1;
    const design::Color grey = billboard_look(test.input(), 2).color;
    EXPECT_EQ(grey.red, std::lround(0.2126 * 200 + 0.7152 * 40 + 0.0722 * 20));
    EXPECT_EQ(grey.red, grey.green);
    EXPECT_EQ(grey.red, grey.blue);
    EXPECT_EQ(billboard_look(test.input(), 0).color, test.element.color);
}

TEST(BillboardLook, AgeMakesUnsure) {
    host_sim::LayerDraft layer = masts();
    layer.attributes[0].uncertainty_growth_per_hour = 0.25f;
    ElementOfTest test(layer);
    test.element.uncertainty = ElementUncertainty::transparency;
    test.element.uncertainty_strength = 1;
    test.time_ns = 102 * kHour_ns;
    EXPECT_EQ(billboard_look(test.input(), 0).color.alpha, 255) << "the time is no date";
    test.has_date = true;
    EXPECT_NEAR(billboard_look(test.input(), 0).color.alpha, 127.5, 1.5);
}

TEST(BillboardLook, NamesSayWhatNobodyKnows) {
    ElementOfTest test(masts());
    test.element.uncertainty = ElementUncertainty::circles;
    const auto name = [&](std::uint32_t n) {
        const ElementInput input = test.input();
        return billboard_name(input, n, billboard_look(input, n));
    };
    EXPECT_EQ(name(0).view(), "Mast A");
    EXPECT_EQ(name(1).view(), "");
    EXPECT_EQ(name(2).view(), "Sendemast Schw\xC3\xA4galp No ?") << "names have 23 bytes";
}

}  // namespace
}  // namespace tedavis::draw::test_billboard_look
