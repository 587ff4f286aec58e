#include "render_core/design/terrain_style.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/base/config_reader.hpp"

namespace tedavis::design::test_terrain_style {
namespace {

struct ReadStyle {
    TerrainStyle style;
    std::string error;
};

ReadStyle read(const std::string& text) {
    base::ConfigReader reader(text, "d.toml");
    base::ConfigSection root = reader.root();
    base::ConfigSection terrain = root.section("terrain");
    ReadStyle read;
    read_terrain_style(terrain, read.style);
    if (!reader.finish()) read.error = std::string(reader.error().message.view());
    return read;
}

TEST(TerrainStyle, AnEmptySectionLeavesTheDefault) {
    const ReadStyle none = read("[terrain]\n");
    EXPECT_EQ(none.error, "");
    EXPECT_TRUE(same_programs(none.style, TerrainStyle{}));
    EXPECT_FALSE(has_lines(none.style.sketch));
}

TEST(TerrainStyle, EveryNameIsReadAsItsTechnique) {
    for (std::size_t n = 0; n < kTerrainTextures; ++n) {
        const ReadStyle got = read("[terrain.texture]\ntechnique = \"" + std::string(kTerrainTextureNames[n]) + "\"\n");
        EXPECT_EQ(got.error, "");
        EXPECT_EQ(static_cast<std::size_t>(got.style.texture), n);
    }
    for (std::size_t n = 0; n < kTerrainShades; ++n) {
        const ReadStyle got = read("[terrain.shade]\ntechnique = \"" + std::string(kTerrainShadeNames[n]) + "\"\n");
        EXPECT_EQ(got.error, "");
        EXPECT_EQ(static_cast<std::size_t>(got.style.shade.technique), n);
    }
}

TEST(TerrainStyle, TheGridStatesItsSpacingInOneUnit) {
    EXPECT_EQ(read("[terrain]\n").style.grid.spacing_m, 0);
    EXPECT_EQ(read("[terrain.grid]\n").style.grid.spacing_m, 1000);
    const ReadStyle miles = read("[terrain.grid]\nspacing_nm = 0.5\ncolor = '#102030'\nstrength = 0.3\n");
    EXPECT_EQ(miles.error, "");
    EXPECT_EQ(miles.style.grid.spacing_m, 926);
    EXPECT_EQ(miles.style.grid.line, (Color{0x10, 0x20, 0x30}));
    EXPECT_EQ(miles.style.grid.strength, 0.3);
    EXPECT_FALSE(fits_pixel_code(miles.style));
    EXPECT_FALSE(same_programs(miles.style, TerrainStyle{}));
    EXPECT_NE(read("[terrain.grid]\nspacing_nm = 1\nspacing_m = 100\n").error.find("state one of them"), std::string::npos);
    EXPECT_NE(read("[terrain.grid]\nspacing_m = 0\n").error, "");
}

TEST(TerrainStyle, HeightsAreATenthOfTheGridsSpacingUnlessStated) {
    const auto heights_m = [](const std::string& keys) {
        const ReadStyle got = read("[terrain.grid]\n" + keys);
        EXPECT_EQ(got.error, "");
        return got.style.grid.height_spacing_m;
    };
    EXPECT_EQ(heights_m(""), 100);
    EXPECT_DOUBLE_EQ(heights_m("spacing_m = 2000\n"), 200);
    EXPECT_DOUBLE_EQ(heights_m("spacing_m = 3000\n"), 200);
    EXPECT_DOUBLE_EQ(heights_m("spacing_m = 4000\n"), 500);
    EXPECT_DOUBLE_EQ(heights_m("spacing_m = 8000\n"), 1000);
    EXPECT_DOUBLE_EQ(heights_m("spacing_m = 10\n"), 1);
    EXPECT_DOUBLE_EQ(heights_m("spacing_nm = 1\n"), 500 * base::kMetresPerFoot);
    EXPECT_DOUBLE_EQ(heights_m("spacing_nm = 0.5\n"), 200 * base::kMetresPerFoot);
    EXPECT_DOUBLE_EQ(heights_m("spacing_arcmin = 1\n"), 500 * base::kMetresPerFoot);
    EXPECT_LE(heights_m("spacing_nm = 60\n"), 10'000);
    EXPECT_EQ(heights_m("height_spacing_m = 70\n"), 70);
    EXPECT_DOUBLE_EQ(heights_m("height_spacing_ft = 1000\n"), 304.8);
    EXPECT_NE(read("[terrain.grid]\nheight_spacing_ft = 100\nheight_spacing_m = 100\n").error.find("state one of them"),
              std::string::npos);
    EXPECT_EQ(read("[terrain]\n").style.grid.height_spacing_m, 0) << "without a grid";
}

TEST(TerrainStyle, TheGridsSpacingIsALengthOrAnAngle) {
    const ReadStyle minutes = read("[terrain.grid]\nspacing_arcmin = 2\n"), length = read("[terrain.grid]\n");
    EXPECT_DOUBLE_EQ(minutes.style.grid.spacing_rad, base::radians(2.0 / 60));
    EXPECT_EQ(minutes.style.grid.spacing_m, 0);
    EXPECT_TRUE(minutes.style.grid.is_shown());
    EXPECT_FALSE(length.style.grid.is_angular());
    EXPECT_EQ(length.style.grid.spacing_m, 1000);
    EXPECT_NE(read("[terrain.grid]\nspacing_arcmin = 1\nspacing_m = 100\n").error.find("state one of them"), std::string::npos);
}

TEST(TerrainStyle, AGridOfNoStrengthIsNone) {
    const ReadStyle got = read("[terrain.grid]\nspacing_nm = 1\nstrength = 0\n");
    EXPECT_EQ(got.error, "");
    EXPECT_FALSE(got.style.grid.is_shown());
}

TEST(TerrainStyle, NaturalGroundHasItsRockAndItsGrain) {
    const ReadStyle got = read(
        "[terrain.texture]\ntechnique = 'material'\nrock_color = '#102030'\nwoods_filter = '#80ff40'\ntree_line_m = 900\ngrain = "
        "0.5\n");
    ASSERT_EQ(got.error, "");
    EXPECT_EQ(got.style.rock, (Color{0x10, 0x20, 0x30}));
    EXPECT_EQ(got.style.grain, 0.5);
    EXPECT_EQ(got.style.tree_line_m, 900);
    EXPECT_EQ(wooded(got.style, {100, 100, 100}), (Color{50, 100, 25}));
}

TEST(TerrainStyle, FileSpeaksDegreesAndTheStyleRadians) {
    const ReadStyle got = read(
        "[terrain.shade]\ntechnique = 'lights'\n[[terrain.shade.light]]\nazimuth_deg = 180\nelevation_deg = 30\nweight = 0.5\n"
        "[[terrain.shade.light]]\nazimuth_deg = 90\n");
    ASSERT_EQ(got.error, "");
    ASSERT_EQ(got.style.shade.light_count, 2u);
    EXPECT_DOUBLE_EQ(got.style.shade.lights[0].azimuth_rad, base::kPi);
    EXPECT_DOUBLE_EQ(got.style.shade.lights[0].elevation_rad, base::kPi / 6);
    EXPECT_DOUBLE_EQ(got.style.shade.lights[0].weight, 0.5);
    EXPECT_DOUBLE_EQ(got.style.shade.lights[1].weight, 1);
}

TEST(TerrainStyle, LightsAreWhiteUnlessTheFileGivesThemAColor) {
    const auto style = [](const std::string& text) {
        const ReadStyle got = read("[terrain.shade]\n" + text);
        EXPECT_EQ(got.error, "");
        return got.style;
    };
    const std::string warm = "[[terrain.shade.light]]\ncolor = '#ffb050'\n", white = "[[terrain.shade.light]]\nweight = 0.5\n";
    const TerrainStyle colored = style("technique = 'lights'\n" + white + warm);
    EXPECT_EQ(colored.shade.lights[0].color, (Color{255, 255, 255}));
    EXPECT_EQ(colored.shade.lights[1].color, (Color{255, 0xB0, 0x50}));
    EXPECT_TRUE(has_colored_light(colored.shade));
    EXPECT_TRUE(has_colored_light(style("ambient_color = '#8090ff'\n").shade));
    EXPECT_FALSE(has_colored_light(style("technique = 'lights'\n" + white + white).shade));
    EXPECT_FALSE(has_colored_light(style("technique = 'lambert'\n" + white + warm).shade)) << "the second light is not used";
    EXPECT_FALSE(has_colored_light(style("technique = 'light_map'\n" + warm).shade)) << "what is baked has no colours";
    EXPECT_FALSE(has_colored_light(style("technique = 'none'\nambient_color = '#8090ff'\n").shade));
    EXPECT_FALSE(same_programs(colored, style("technique = 'lights'\n" + white + white)));
    EXPECT_TRUE(same_programs(colored, style("technique = 'lights'\n" + warm + warm))) << "which colour may change";
    EXPECT_NE(read("[terrain.shade]\n[[terrain.shade.light]]\ncolor = 'warm'\n").error.find("d.toml:3"), std::string::npos);
}

TEST(TerrainStyle, TheSunMovesByTheSourceOrStandsAtAnInstant) {
    const ReadStyle moving = read("[terrain.shade]\nfollows_sun = true\n");
    EXPECT_EQ(moving.error, "");
    EXPECT_TRUE(moving.style.shade.follows_sun);
    EXPECT_FALSE(moving.style.shade.sun_is_fixed);
    const ReadStyle fixed = read("[terrain.shade]\nfollows_sun = true\nsun_utc = '2026-06-21T10:00:00Z'\n");
    EXPECT_EQ(fixed.error, "");
    EXPECT_TRUE(fixed.style.shade.sun_is_fixed);
    EXPECT_EQ(fixed.style.shade.sun_utc.ns, 1'782'036'000'000'000'000);
    EXPECT_NE(read("[terrain.shade]\nfollows_sun = true\nsun_utc = 'noon'\n").error.find("d.toml:3"), std::string::npos);
    EXPECT_NE(read("[terrain.shade]\nsun_utc = '2026-06-21T10:00:00Z'\n").error.find("follows_sun = true"), std::string::npos);
    EXPECT_NE(read("[terrain.shade]\ntechnique = 'light_map'\nfollows_sun = true\n").error.find("baked light"),
              std::string::npos);
}

TEST(TerrainStyle, FaultsNameFileLineAndWhatToDo) {
    EXPECT_NE(read("[terrain.texture]\ntechnique = 'velvet'\n").error.find("d.toml:2"), std::string::npos);
    EXPECT_NE(read("[terrain.sketch]\nridges = 1.5\n").error.find("d.toml:2"), std::string::npos);
    EXPECT_NE(read("[terrain.sketch]\nline_color = 'ink'\n").error.find("#rrggbb"), std::string::npos);
    EXPECT_NE(read("[terrain.sketch]\nridgess = 1\n").error.find("ridgess"), std::string::npos);
    std::string five = "[terrain.shade]\n";
    for (int n = 0; n < 5; ++n) five += "[[terrain.shade.light]]\nazimuth_deg = 10\n";
    EXPECT_NE(read(five).error.find("at most 4"), std::string::npos);
}

TEST(TerrainStyle, OnlyTheMapsThatATechniqueReadsAreNeeded) {
    TerrainStyle bare;
    bare.texture = TerrainTexture::plain;
    bare.shade.technique = TerrainShade::none;
    for (std::size_t map = 0; map < kBakedMaps; ++map) EXPECT_FALSE(needs_map(bare, static_cast<BakedMap>(map)));
    TerrainStyle style = bare;
    style.sketch.silhouettes = 1;  // from the depth alone
    EXPECT_FALSE(needs_map(style, BakedMap::form));
    style.sketch.valleys = 1;
    EXPECT_TRUE(needs_map(style, BakedMap::form));
    EXPECT_FALSE(needs_map(style, BakedMap::light));
    style = bare;
    style.texture = TerrainTexture::local_relief;
    EXPECT_TRUE(needs_map(style, BakedMap::light));
    style = bare;
    style.shade.technique = TerrainShade::aperture;
    EXPECT_TRUE(needs_map(style, BakedMap::aperture));
    style = bare;
    style.shade.cast_shadows = true;
    EXPECT_TRUE(needs_map(style, BakedMap::horizon));
    style = bare;
    style.texture = TerrainTexture::image;
    EXPECT_TRUE(needs_map(style, BakedMap::drape));
}

TEST(TerrainStyle, NormalsComeFromTheMeshUnlessTheMapsAreAskedFor) {
    const TerrainStyle mesh = read("[terrain.shade]\ntechnique = \"lambert\"\n").style;
    EXPECT_FALSE(MapSet(mesh).any());
    EXPECT_TRUE(fits_pixel_code(mesh));
    const TerrainStyle baked = read("[terrain.shade]\ntechnique = \"lambert\"\nnormals = \"baked\"\n").style;
    EXPECT_TRUE(needs_map(baked, BakedMap::form));
    EXPECT_FALSE(fits_pixel_code(baked));
    EXPECT_FALSE(same_programs(mesh, baked));
    EXPECT_NE(read("[terrain.shade]\nnormals = \"guessed\"\n").error, "");
}

TEST(TerrainStyle, CodesHoldHeightLightClassAndDistanceAndNothingElse) {
    const auto fits = [](const std::string& text) { return fits_pixel_code(read(text).style); };
    EXPECT_TRUE(fits("[terrain.texture]\ntechnique = \"plain\"\n"));
    EXPECT_TRUE(fits("[terrain.sketch]\nsilhouettes = 1\n"));
    EXPECT_TRUE(fits("[terrain.shade]\ntechnique = \"none\"\nnormals = \"baked\"\n")) << "nothing is shaded";
    EXPECT_FALSE(fits("[terrain.texture]\ntechnique = \"slope\"\n"));
    EXPECT_FALSE(fits("[terrain.shade]\ntechnique = \"phong\"\n"));
    EXPECT_FALSE(fits("[terrain.shade]\nambient_color = \"#a0b0ff\"\n")) << "light of a colour is more than one number";
    EXPECT_FALSE(fits("[terrain.shade]\ncast_shadows = true\n"));
    EXPECT_FALSE(fits("[terrain.shade]\nambient_occlusion = 0.5\n"));
    EXPECT_FALSE(fits("[terrain.shade]\nopenness = 0.5\n"));
    EXPECT_FALSE(fits("[terrain.sketch]\ncontours = 1\n"));
}

TEST(TerrainStyle, ParametersMayChangeWhileRunningTechniquesMayNot) {
    TerrainStyle a, b;
    b.shade.ambient = 0.9;
    b.sketch.line = {1, 2, 3};
    b.plain = {4, 5, 6};
    EXPECT_TRUE(same_programs(a, b));
    b.sketch.contours = 0.5;
    EXPECT_FALSE(same_programs(a, b));
    a.sketch.contours = 1;
    EXPECT_TRUE(same_programs(a, b));
    b.texture = TerrainTexture::slope;
    EXPECT_FALSE(same_programs(a, b));
}

}  // namespace
}  // namespace tedavis::design::test_terrain_style
