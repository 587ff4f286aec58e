#include "render_core/design/design_settings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace tedavis::design {
namespace {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string error_of(const std::string& text) {
    const auto design = read_design_settings(text, "d.toml");
    return design.ok() ? "" : std::string(design.error().sentence.view());
}

TEST(DesignSettings, EveryShippedDesignLoadsUnderItsFileName) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(TEDAVIS_SOURCE_DIR "/configs/designs")) {
        const auto design = read_design_settings(file_text(entry.path()), entry.path().string());
        ASSERT_TRUE(design.ok()) << design.error().sentence.view();
        EXPECT_EQ(design.value().name.view(), entry.path().stem().string());
        EXPECT_EQ(first_band_out_of_order(design.value().warning_bands), design.value().warning_bands.size());
        ++files;
    }
    EXPECT_GE(files, 5u);
}

TEST(DesignSettings, TheDefaultFileStatesTheBuiltInValues) {
    const auto read = read_design_settings(file_text(TEDAVIS_SOURCE_DIR "/configs/designs/default.toml"), "default.toml");
    ASSERT_TRUE(read.ok());
    const DesignSettings& file = read.value();
    const DesignSettings built_in = default_design_settings();
    EXPECT_DOUBLE_EQ(file.view.horizontal_field_of_view_rad, built_in.view.horizontal_field_of_view_rad);
    EXPECT_EQ(file.terrain.tau_px, built_in.terrain.tau_px);
    EXPECT_EQ(file.terrain.sea, built_in.terrain.sea);
    EXPECT_EQ(file.terrain.unknown, built_in.terrain.unknown);
    EXPECT_EQ(file.sky.zenith, built_in.sky.zenith);
    EXPECT_EQ(file.sky.ground_horizon, built_in.sky.ground_horizon);
    EXPECT_EQ(file.sky.haze_distance_m, built_in.sky.haze_distance_m);
    EXPECT_EQ(file.degradation.vertical_accuracy_m, built_in.degradation.vertical_accuracy_m);
    EXPECT_EQ(file.degradation.terrain_error_px, built_in.degradation.terrain_error_px);
    ASSERT_EQ(file.terrain.palette.size(), built_in.terrain.palette.size());
    for (std::size_t i = 0; i < file.terrain.palette.size(); ++i)
        EXPECT_EQ(file.terrain.palette[i].color, built_in.terrain.palette[i].color);
}

TEST(DesignSettings, ConvertsUnits) {
    const auto read = read_design_settings(
        "name = 'x'\n[view]\nhorizontal_field_of_view_deg = 90\neye_forward_right_down_m = [1.5, -0.25, -2]\n"
        "[warning]\nprofile = 'custom'\n[[warning.band]]\nlower_ft = 100\ncolor = '#ff0000'\nstrength = 0.5\n"
        "[[warning.band]]\nlower_ft = -1000\nlower_gear_down_ft = -500\ncolor = '#00ff00'\nstrength = 1\n",
        "d.toml");
    ASSERT_TRUE(read.ok()) << read.error().sentence.view();
    EXPECT_NEAR(read.value().view.horizontal_field_of_view_rad, 1.5707963267948966, 1e-15);
    EXPECT_EQ(read.value().view.eye_down_m, -2);
    ASSERT_EQ(read.value().warning_bands.size(), 2u);
    EXPECT_NEAR(read.value().warning_bands[0].lower_m, 30.48, 1e-12);
    EXPECT_NEAR(read.value().warning_bands[0].lower_gear_down_m, 30.48, 1e-12);
    EXPECT_NEAR(read.value().warning_bands[1].lower_gear_down_m, -152.4, 1e-12);
}

TEST(DesignSettings, EveryFaultNamesItsLine) {
    const std::pair<const char*, const char*> faults[] = {
        {"name = 'x'\n[view]\nhorizontal_field_of_view_deg = 200\n", "d.toml:3: 'horizontal_field_of_view_deg'"},
        {"name = 'x'\n[view]\nhorizontal_field_of_view_deg = nan\n", "d.toml:3: "},
        {"name = 'x'\n[terrain]\n\nsea_color = 'blue'\n", "d.toml:4: 'sea_color' is no colour"},
        {"name = 'x'\n[terrain]\ntau = 2\n", "d.toml:3: unknown key 'terrain.tau'"},
        {"name = 'x'\n[warning]\nprofile = 'radar'\n", "d.toml:3: 'profile' must be one of: egpws, garmin, custom"},
        {"name = 'x'\n[warning]\nprofile = 'custom'\n", "d.toml:3: 'profile' 'custom' needs"},
        {"name = 'x'\n[[terrain.palette]]\nheight_m = 5\ncolor = '#000000'\n[[terrain.palette]]\nheight_m = 5\ncolor = "
         "'#000000'\n",
         "d.toml:6: 'height_m' must lie above"},
        {"name = 'x'\n[warning]\nprofile = 'custom'\n[[warning.band]]\nlower_ft = 0\ncolor = '#000000'\nstrength = 1\n"
         "[[warning.band]]\nlower_ft = 10\ncolor = '#000000'\nstrength = 1\n",
         "d.toml:9: 'lower_ft' must lie below"},
        {"name = 'x'\n[symbology]\nphase = 1\n", "d.toml:3: 'phase' must be true or false"},
        {"name = ''\n", "d.toml:1: 'name'"},
        {"name = 'x'\nname = 'y'\n", "d.toml:2: "},
        {"", "name"},
    };
    for (const auto& [text, expected] : faults)
        EXPECT_NE(error_of(text).find(expected), std::string::npos) << text << "\n-> " << error_of(text);
}

TEST(DesignSettings, TooManyStopsAndBandsAreRefused) {
    std::string palette = "name = 'x'\n", bands = "name = 'x'\n[warning]\nprofile = 'custom'\n";
    for (int i = 0; i < 17; ++i) palette += "[[terrain.palette]]\nheight_m = " + std::to_string(i) + "\ncolor = '#000000'\n";
    for (int i = 0; i < 9; ++i)
        bands += "[[warning.band]]\nlower_ft = " + std::to_string(-i) + "\ncolor = '#000000'\nstrength = 0\n";
    EXPECT_NE(error_of(palette).find("at most 16"), std::string::npos);
    EXPECT_NE(error_of(bands).find("at most 8"), std::string::npos);
}

TEST(DesignSettings, TruncatedFilesNeverLoadAsWholeWithoutTheirName) {
    const std::string whole = file_text(TEDAVIS_SOURCE_DIR "/configs/designs/default.toml");
    const std::size_t name_end = whole.find("name = \"default\"") + 16;
    for (std::size_t length = 0; length < name_end; ++length) EXPECT_FALSE(error_of(whole.substr(0, length)).empty()) << length;
}

TEST(HeightPalette, HitsStopsInterpolatesBetweenAndHoldsBeyond) {
    HeightPalette palette;
    ASSERT_TRUE(palette.try_push_back({0, {0, 0, 0}}));
    ASSERT_TRUE(palette.try_push_back({100, {200, 100, 0}}));
    ASSERT_TRUE(palette.try_push_back({300, {0, 100, 50}}));
    EXPECT_EQ(color_of_height(palette, -1000), (Color{0, 0, 0}));
    EXPECT_EQ(color_of_height(palette, 100), (Color{200, 100, 0}));
    EXPECT_EQ(color_of_height(palette, 50), (Color{100, 50, 0}));
    EXPECT_EQ(color_of_height(palette, 200), (Color{100, 100, 25}));
    EXPECT_EQ(color_of_height(palette, 9000), (Color{0, 100, 50}));
}

}  // namespace
}  // namespace tedavis::design
