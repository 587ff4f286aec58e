#include "host_sim/contract/color_groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/measure/color_vision.hpp"
#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim::test_color_groups {
namespace {

using design::Color;
using ::testing::HasSubstr;

/// On plain ground, with two opaque bands.
design::DesignSettings plain_design(Color ground, Color first, Color second) {
    design::DesignSettings design = design::default_design_settings();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = ground;
    design.warning_colors = true;
    design.warning_bands.clear();
    EXPECT_TRUE(design.warning_bands.try_push_back({0, 0, first, 1}));
    EXPECT_TRUE(design.warning_bands.try_push_back({-100, -100, second, 1}));
    return design;
}

double difference(Color a, Color b, ColorVision vision) {
    return design::color_difference(design::lab_of(seen_with(vision, design::linear_rgb(a))),
                                    design::lab_of(seen_with(vision, design::linear_rgb(b))));
}

constexpr Color kGrey{128, 128, 128}, kRed{220, 50, 47}, kGreen{85, 140, 30}, kBlue{40, 90, 220};

TEST(ColorGroups, RedAndGreenAreAlikeWithoutTheConesForGreen) {
    const auto alike = least_color_gap(plain_design(kGrey, kRed, kGreen), {"warnings"}, 1);
    ASSERT_TRUE(alike.has_value());
    double least = 1000;
    for (const ColorVision vision : kColorVisions) least = std::min(least, difference(kRed, kGreen, vision));
    EXPECT_NEAR(alike->difference, least, 1e-9);
    EXPECT_LT(alike->difference, 0.4 * difference(kRed, kGreen, ColorVision::normal)) << "in normal vision they are far apart";
    EXPECT_THAT(alike->words, HasSubstr("#dc322f"));
    const auto apart = least_color_gap(plain_design(kGrey, kRed, kBlue), {"warnings"}, 1);
    EXPECT_GT(apart->difference, 2 * alike->difference);
}

TEST(ColorGroups, BandsLieOverTheGroundWithTheirStrength) {
    design::DesignSettings design = plain_design(kGrey, kRed, kBlue);
    const double strong = least_color_gap(design, {"warnings", "ground"}, 1)->difference;
    for (design::WarningBand& band : design.warning_bands) band.strength = 0.2;
    const double weak = least_color_gap(design, {"warnings", "ground"}, 1)->difference;
    EXPECT_LT(weak, 0.5 * strong);
    double least = 1000;
    for (const ColorVision vision : kColorVisions)
        for (const Color band : {kRed, kBlue})
            least = std::min(least, difference(design::blended(kGrey, band, 0.2), kGrey, vision));
    EXPECT_NEAR(weak, least, 1e-9);
    design.warning_bands[1].color = {215, 50, 47};
    EXPECT_LT(least_color_gap(design, {"warnings"}, 1)->difference, 1);
    EXPECT_GT(least_color_gap(design, {"warnings", "ground"}, 1)->difference, 1) << "there they are not compared with each other";
}

TEST(ColorGroups, TwoDensitiesOfOneHueAreNotComparedNorIsWhatLiesOverOtherGround) {
    EXPECT_FALSE(least_color_gap(plain_design(kGrey, kRed, kRed), {"warnings"}, 1).has_value());
    const Color dark{0, 0, 0}, as_band_over_dark = design::blended(dark, kRed, 0.5);
    design::DesignSettings design = plain_design(kGrey, kRed, kRed);
    for (design::WarningBand& band : design.warning_bands) band.strength = 0.5;
    design.terrain.style.texture = design::TerrainTexture::hypsometric;
    design.terrain.palette.stops.clear();
    EXPECT_TRUE(design.terrain.palette.stops.try_push_back({0, dark}));
    EXPECT_TRUE(design.terrain.palette.stops.try_push_back({1000, as_band_over_dark}));
    EXPECT_GT(least_color_gap(design, {"warnings", "ground"}, 1)->difference, 3) << "ground up there is as the band down here";
    design.terrain.palette.stops[1].color = kRed;
    EXPECT_NEAR(least_color_gap(design, {"warnings", "ground"}, 1)->difference, 0, 1e-9) << "red over red";
}

TEST(ColorGroups, RolesHaveTheColorsOfTheirElements) {
    design::DesignSettings design = plain_design(kGrey, kRed, kBlue);
    design.data.elements.clear();
    EXPECT_FALSE(least_color_gap(design, {"obstacle", "traffic"}, 1).has_value()) << "neither is shown";
    design::DataElement obstacle, traffic;
    obstacle.role = scene::LayerRole::obstacle;
    obstacle.color = kRed;
    traffic.role = scene::LayerRole::traffic;
    traffic.color = kBlue;
    EXPECT_TRUE(design.data.elements.try_push_back(obstacle));
    EXPECT_TRUE(design.data.elements.try_push_back(traffic));
    const double apart = least_color_gap(design, {"obstacle", "traffic"}, 1)->difference;
    double least = 1000;
    for (const ColorVision vision : kColorVisions) least = std::min(least, difference(kRed, kBlue, vision));
    EXPECT_NEAR(apart, least, 1e-9);
    design.data.elements[1].by_color.attribute = design::DataName("speed");
    EXPECT_FALSE(least_color_gap(design, {"obstacle", "traffic"}, 1).has_value()) << "colours of values are the palette's";
}

TEST(ColorGroups, LessLightBringsColorsTogether) {
    const design::DesignSettings design = plain_design(kGrey, kRed, kBlue);
    EXPECT_LT(least_color_gap(design, {"ground", "sea"}, 0.3)->difference,
              least_color_gap(design, {"ground", "sea"}, 1)->difference);
    design::DesignSettings without = design;
    without.warning_colors = false;
    EXPECT_TRUE(least_color_gap(without, {"warnings"}, 1).has_value()) << "the colors of the terrain alert";
    EXPECT_NE(least_color_gap(without, {"warnings"}, 1)->difference, least_color_gap(design, {"warnings"}, 1)->difference);
}

TEST(ColorGroups, AreNamed) {
    for (const char* name : {"warnings", "ground", "sea", "unknown", "obstacle", "storm_cell"})
        EXPECT_TRUE(is_color_group(name)) << name;
    for (const char* name : {"", "warning", "clouds"}) EXPECT_FALSE(is_color_group(name)) << name;
}

}  // namespace
}  // namespace tedavis::host_sim::test_color_groups
