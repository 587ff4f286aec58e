#include "host_sim/measure/symbology_palette_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/measure/color_vision.hpp"
#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim::test_symbology_palette_check {
namespace {

using design::SymbologyLight;
using design::SymbologyPalettes;
using design::SymbolRole;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr SymbologyLight kDay = SymbologyLight::day, kNight = SymbologyLight::night;

SymbologyPalettes standard() { return design::standard_symbology_palettes(); }
design::Color& color_of(SymbologyPalettes& palettes, SymbologyLight light, SymbolRole role) {
    return palettes.of(light).colors[static_cast<std::size_t>(role)];
}

TEST(SymbologyPaletteCheck, TheStandardPaletteHolds) {
    EXPECT_THAT(symbology_palette_faults(standard(), "p"), IsEmpty());
    for (const SymbologyLight light : {kDay, kNight}) EXPECT_GE(least_role_gap(standard(), light).difference, kMinRoleDifference);
}

TEST(SymbologyPaletteCheck, TwoRolesAlikeAreRefusedWithTheirNames) {
    SymbologyPalettes alike = standard();
    color_of(alike, kNight, SymbolRole::caution) = color_of(alike, kNight, SymbolRole::warning);
    EXPECT_THAT(symbology_palette_faults(alike, "p"),
                ElementsAre(HasSubstr("p: warning and caution in normal vision by night differ by 0.00 (CIEDE2000)")));
}

TEST(SymbologyPaletteCheck, RolesThatNormalVisionTellsApartMayBeAlikeWithoutOneKindOfCones) {
    SymbologyPalettes palettes = standard();
    palettes.told_apart.clear();
    const RoleGap gap = least_role_gap(palettes, kDay);
    EXPECT_LT(gap.difference, kMinRoleDifference) << "the reason why the palette states a pair";
    EXPECT_EQ(gap.words, "engaged and reference in protanopia");
    // By the two colors and the simulation themselves.
    const auto seen = [&](SymbolRole role) {
        return lab_of(seen_with(ColorVision::protan, linear_rgb(palettes.of(kDay).color(role))));
    };
    EXPECT_DOUBLE_EQ(gap.difference, color_difference(seen(SymbolRole::engaged), seen(SymbolRole::reference)));
    EXPECT_THAT(symbology_palette_faults(palettes, "p"), ElementsAre(HasSubstr("[[told_apart]]")));
}

TEST(SymbologyPaletteCheck, ADarkSignHasTooLittleContrastWithItsRim) {
    SymbologyPalettes dark = standard();
    color_of(dark, kNight, SymbolRole::warning) = {150, 20, 20};
    EXPECT_THAT(symbology_palette_faults(dark, "p"),
                ElementsAre(HasSubstr("p: warning by night has a contrast of 2."), HasSubstr("with readout_ground")));
}

/// Text on a readout has no rim.
TEST(SymbologyPaletteCheck, ALightGroundOfReadoutsIsRefused) {
    SymbologyPalettes light = standard();
    color_of(light, kDay, SymbolRole::readout_ground) = {176, 180, 184};
    EXPECT_THAT(symbology_palette_faults(light, "p"), ElementsAre(HasSubstr("with readout_ground and needs 4.50")));
}

TEST(SymbologyPaletteCheck, NightIsDarkerThanDay) {
    SymbologyPalettes bright = standard();
    color_of(bright, kNight, SymbolRole::scale) = {255, 255, 255};
    EXPECT_THAT(symbology_palette_faults(bright, "p"), ElementsAre(HasSubstr("scale is not darker by night than by day")));
    SymbologyPalettes clear = standard();
    color_of(clear, kNight, SymbolRole::tape_ground).alpha = 40;
    EXPECT_THAT(symbology_palette_faults(clear, "p"), ElementsAre(HasSubstr("tape_ground is not darker")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_symbology_palette_check
