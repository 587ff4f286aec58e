#include "render_core/draw/data/solid_look.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_solid_look {
namespace {

using design::ElementUncertainty;

SolidLook look_with(ElementUncertainty uncertainty, double opacity = 1) {
    test_support::ElementOfTest test(test_support::small_grid());
    test.element.uncertainty = uncertainty;
    test.element.opacity = opacity;
    test.element.ghost = 0.25;
    test.element.uncertainty_strength = 0.5;
    test.element.uncertainty_levels = 4;
    return look_of(test.input());
}

TEST(SolidLook, IsWhatTheDesignSays) {
    const SolidLook look = look_with(ElementUncertainty::saturation, 0.75);
    EXPECT_EQ(look.opacity, 0.75f);
    EXPECT_EQ(look.ghost, 0.25f);
    EXPECT_EQ(look.fading, SolidFading::saturation);
    EXPECT_EQ(look.fading_strength, 0.5f);
    EXPECT_EQ(look.fading_levels, 4.0f);
    EXPECT_EQ(look.group, 3);
}

TEST(SolidLook, HasTheSurfaceGridWhereTheElementAsks) {
    test_support::ElementOfTest test(test_support::small_grid());
    EXPECT_FALSE(look_of(test.input()).has_grid);
    test.element.grid = true;
    EXPECT_TRUE(look_of(test.input()).has_grid);
    SolidLook other = look_of(test.input());
    other.has_grid = false;
    EXPECT_FALSE(other == look_of(test.input())) << "they are drawn apart";
}

TEST(SolidLook, WhatIsNotOpaqueIsMixed) {
    EXPECT_FALSE(look_with(ElementUncertainty::none).is_mixed);
    EXPECT_FALSE(look_with(ElementUncertainty::saturation).is_mixed);
    EXPECT_TRUE(look_with(ElementUncertainty::transparency).is_mixed);
    EXPECT_TRUE(look_with(ElementUncertainty::none, 0.5).is_mixed);
}

TEST(SolidLook, UncertaintyThatIsDrawnOtherwiseFadesNothing) {
    EXPECT_EQ(look_with(ElementUncertainty::widening).fading, SolidFading::none);
    EXPECT_EQ(look_with(ElementUncertainty::circles).fading, SolidFading::none);
}

}  // namespace
}  // namespace tedavis::draw::test_solid_look
