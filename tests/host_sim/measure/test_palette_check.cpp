#include "host_sim/measure/palette_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/measure/color_vision.hpp"
#include "render_core/design/color_difference.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_palette_check {
namespace {

using design::Color;
using design::Palette;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Palette shipped(const std::string& name) { return test_support::ShippedFiles().find({name, ""}).value(); }

Palette palette_of(std::initializer_list<Color> colors) {
    Palette palette;
    double value = 0;
    for (const Color color : colors) EXPECT_TRUE(palette.stops.try_push_back({value++, color}));
    return palette;
}

/// The alpine palette with one stop seeded.
Palette seeded(std::size_t stop, Color color) {
    Palette palette = design::alpine_palette();
    palette.stops[stop].color = color;
    return palette;
}

std::vector<std::string> in_default_design(const Palette& palette) {
    design::DesignSettings design = design::default_design_settings();
    design.warning_colors = !palette.fits_terrain;  // as `tedavis check` does: natural ground has no bands
    return palette_faults_in_design(palette, design, "p");
}

TEST(PaletteCheck, EveryShippedPaletteHoldsByItselfAndInEveryShippedDesign) {
    std::size_t palettes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/configs/palettes")) {
        if (entry.is_directory()) continue;  // palettes of the symbology
        const Palette palette = shipped(entry.path().stem().string());
        EXPECT_THAT(palette_faults(palette, "p"), IsEmpty()) << entry.path();
        EXPECT_THAT(in_default_design(palette), IsEmpty()) << entry.path();
        ++palettes;
    }
    EXPECT_GE(palettes, 15u);
    const std::filesystem::path designs = test_support::source_dir() + "/configs/designs";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(designs)) {
        if (entry.path().extension() != ".toml") continue;
        const std::filesystem::path name = std::filesystem::relative(entry.path(), designs).replace_extension();
        const design::DesignSettings design = test_support::shipped_design(name.string());
        EXPECT_THAT(palette_faults_in_design(design.terrain.palette, design, "p"), IsEmpty()) << entry.path();
    }
}

TEST(PaletteCheck, AStopThatIsNotBrighterIsNamed) {
    const Palette palette = seeded(4, {0x8C, 0x6E, 0x5A});
    EXPECT_THAT(palette_faults(palette, "p.toml")[0],
                ::testing::AllOf(HasSubstr("p.toml: in normal vision stop 5 (#8c6e5a)"), HasSubstr("needs 5.0")));
    Palette falling = palette_of({{240, 240, 240}, {170, 170, 170}, {100, 100, 100}});
    EXPECT_THAT(palette_faults(falling, "p"), IsEmpty()) << "darker all the way is an order too";
    falling.kind = design::PaletteKind::diverging;
    EXPECT_THAT(palette_faults(falling, "p"), IsEmpty()) << "both arms go the same way, and all differ";
}

TEST(PaletteCheck, KindsHaveNoOrderButMustDiffer) {
    Palette kinds = palette_of({{0x33, 0x50, 0x3C}, {0xEF, 0xE6, 0xDC}, {0x86, 0x72, 0x7A}});
    EXPECT_FALSE(palette_faults(kinds, "p").empty()) << "control: lightness goes there and back";
    kinds.kind = design::PaletteKind::nominal;
    EXPECT_THAT(palette_faults(kinds, "p"), IsEmpty());
    kinds.stops[2].color = {0x35, 0x52, 0x3E};
    EXPECT_THAT(palette_faults(kinds, "p")[0], HasSubstr("stop 3 (#35523e) differs from stop 1"));
}

TEST(PaletteCheck, ArmsThatOneCannotTellApartAreNamed) {
    Palette arms = palette_of({{0x90, 0x30, 0x30}, {0xF0, 0xF0, 0xF0}, {0x2A, 0x5A, 0x28}});  // red and green of one lightness
    arms.kind = design::PaletteKind::diverging;
    const auto faults = palette_faults(arms, "p");
    ASSERT_FALSE(faults.empty());
    for (const std::string& fault : faults) EXPECT_THAT(fault, ::testing::Not(HasSubstr("normal vision")));
    EXPECT_THAT(faults, ::testing::Contains(HasSubstr("in deuteranopia stop 3 (#2a5a28) differs from stop 1 (#903030) by ")));
}

TEST(PaletteCheck, NeighboursThatLookAlikeAreNamedForEachVision) {
    const auto near = palette_faults(palette_of({{100, 100, 100}, {112, 112, 112}, {240, 240, 240}}), "p");
    ASSERT_EQ(near.size(), 8u) << "lightness and distance, in each vision";
    EXPECT_THAT(near[1], HasSubstr("in normal vision stop 2 (#707070) differs from stop 1 (#646464) by "));
    EXPECT_THAT(near[1], HasSubstr("needs 7.5"));
    EXPECT_THAT(near[7], HasSubstr("in tritanopia"));
    EXPECT_THAT(near[7], HasSubstr("needs 6.0"));
}

TEST(PaletteCheck, AnOrderOfHuesTurnsOneWayInEveryVision) {
    // Yellow, orange, red-violet, indigo: one way around, and told apart by lightness without red or green.
    Palette hues = palette_of({{0xF0, 0xE0, 0x60}, {0xE0, 0x90, 0x40}, {0xA8, 0x40, 0x68}, {0x40, 0x20, 0x70}});
    hues.order = design::PaletteOrder::hue;
    EXPECT_THAT(palette_faults(hues, "p"), IsEmpty());
    std::swap(hues.stops[1].color, hues.stops[2].color);
    EXPECT_THAT(palette_faults(hues, "p")[0], HasSubstr("stop 3 (#e09040) does not go on in the order of hues"));
    std::swap(hues.stops[1].color, hues.stops[2].color);
    hues.stops[1].color = {0xA0, 0xA0, 0xA0};
    EXPECT_THAT(palette_faults(hues, "p")[0], HasSubstr("stop 2 (#a0a0a0) does not go on")) << "a grey has no hue";
    // Red, yellow, green, cyan of one lightness: fine in normal vision, folded without green.
    Palette rainbow = palette_of({{0xF0, 0x60, 0x60}, {0xB0, 0x90, 0x10}, {0x30, 0xB0, 0x30}, {0x10, 0xB0, 0xB0}});
    rainbow.order = design::PaletteOrder::hue;
    const auto faults = palette_faults(rainbow, "p");
    ASSERT_FALSE(faults.empty());
    for (const std::string& fault : faults) EXPECT_THAT(fault, HasSubstr("opia"));
}

TEST(PaletteCheck, ClassesThatSinkInTheShadeAreNamed) {
    design::DesignSettings design = design::default_design_settings();
    EXPECT_THAT(palette_faults_in_design(design.terrain.palette, design, "p"), IsEmpty());
    design.terrain.style.shade.ambient = 0.05;
    const auto faults = palette_faults_in_design(design.terrain.palette, design, "p");
    ASSERT_FALSE(faults.empty());
    EXPECT_THAT(faults[0], HasSubstr("p: in 5.0 % of the light stop "));
    EXPECT_THAT(faults[0], HasSubstr("needs 2.0"));
}

TEST(PaletteCheck, ColorsNearTheSeaTheMissingDataOrABandAreNamed) {
    EXPECT_THAT(in_default_design(seeded(0, {0x34, 0x50, 0x70})),
                ::testing::Contains(HasSubstr("differs from the sea (#305880) by ")));
    EXPECT_THAT(in_default_design(seeded(3, {0x50, 0x38, 0x2C})),
                ::testing::Contains(HasSubstr("differs from missing data (#4a3226)")));
    const auto green = in_default_design(seeded(1, {0x5A, 0x7D, 0x3C}));  // the lowlands before palettes were checked
    EXPECT_THAT(green, ::testing::Contains(HasSubstr("the warning band from -1000.0 ft")));
    EXPECT_THAT(green, ::testing::Contains(HasSubstr("the warning band from -2000.0 ft")));
    design::DesignSettings quiet = design::default_design_settings();
    quiet.warning_colors = false;
    EXPECT_THAT(palette_faults_in_design(seeded(1, {0x5A, 0x7D, 0x3C}), quiet, "p"), IsEmpty()) << "no band is displayed";
}

TEST(PaletteCheck, ObjectsInTheAirMayHaveTheColorsOfWarningsButGroundMayNot) {
    Palette tube = shipped("data_wind_speed_tube");
    EXPECT_EQ(tube.purpose, design::PalettePurpose::objects);
    EXPECT_THAT(in_default_design(tube), IsEmpty());
    for (const design::PalettePurpose purpose : {design::PalettePurpose::data, design::PalettePurpose::terrain}) {
        tube.purpose = purpose;
        EXPECT_THAT(in_default_design(tube), ::testing::Contains(HasSubstr("the warning band")));
    }
    Palette blues = shipped("data_cross_wind");
    EXPECT_THAT(in_default_design(blues), IsEmpty());
    blues.purpose = design::PalettePurpose::data;
    EXPECT_THAT(in_default_design(blues), ::testing::Contains(HasSubstr("the sea")));
    blues.purpose = design::PalettePurpose::objects;
    blues.stops[3].color = {0xB8, 0x40, 0xB8};
    EXPECT_THAT(in_default_design(blues), ::testing::Contains(HasSubstr("missing data"))) << "nor may they look like no data";
}

TEST(PaletteCheck, ColorsBetweenTheStopsCount) {
    // Half way from one stop to the next lies the sea.
    design::DesignSettings design = design::default_design_settings();
    design.warning_colors = false;
    design.terrain.sea = design::blended(design.terrain.palette.stops[2].color, design.terrain.palette.stops[3].color, 0.5);
    EXPECT_THAT(palette_faults_in_design(design.terrain.palette, design, "p"), ElementsAre(HasSubstr("the sea")));
}

TEST(PaletteCheck, TheSafePaletteKeepsTheWidestStepsInEveryVision) {
    const auto least = [](const Palette& palette) {
        double smallest = 1000;
        for (const ColorVision vision : kColorVisions)
            for (std::size_t i = 0; i + 1 < palette.stops.size(); ++i)
                smallest =
                    std::min(smallest, color_difference(lab_of(seen_with(vision, linear_rgb(palette.stops[i].color))),
                                                        lab_of(seen_with(vision, linear_rgb(palette.stops[i + 1].color)))));
        return smallest;
    };
    const double safe = least(shipped("colour_vision_safe"));
    EXPECT_GT(safe, 9);
    EXPECT_GT(safe, least(shipped("alpine")));
    EXPECT_GT(safe, least(shipped("muted_relief")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_palette_check
