#include "render_core/design/view_effects.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::design::test_view_effects {
namespace {

/// Empty where the text is accepted.
std::string read(const std::string& text, ViewEffects& effects) {
    base::ConfigReader reader(text, "d.toml");
    read_view_effects(reader.root(), effects);
    return reader.finish() ? std::string() : std::string(reader.error().message.view());
}

TEST(ViewEffects, NothingIsAskedForByDefault) {
    ViewEffects effects;
    EXPECT_EQ(read("", effects), "");
    EXPECT_EQ(effects.antialiasing, Antialiasing::off);
    EXPECT_EQ(effects.depth_of_field.blur_px, 0);
}

TEST(ViewEffects, AreWhatTheFileSays) {
    ViewEffects effects;
    EXPECT_EQ(read("antialiasing = true\n[depth_of_field]\nblur_px = 3\nfocus_near_m = 500\nfocus_far_m = 4000\n"
                   "layers = \"data\"\nfocus_role = \"storm_cell\"\n",
                   effects),
              "");
    EXPECT_EQ(effects.antialiasing, Antialiasing::on);
    EXPECT_EQ(effects.depth_of_field.blur_px, 3);
    EXPECT_EQ(effects.depth_of_field.focus_near_m, 500);
    EXPECT_EQ(effects.depth_of_field.focus_far_m, 4000);
    EXPECT_EQ(effects.depth_of_field.focus_role, scene::LayerRole::storm_cell);
    EXPECT_FALSE(effects.depth_of_field.on_terrain);
    EXPECT_TRUE(effects.depth_of_field.on_data);
}

TEST(ViewEffects, AntialiasingMayBeLeftToTheDevice) {
    ViewEffects effects;
    EXPECT_EQ(read("antialiasing = \"device\"\n", effects), "");
    EXPECT_EQ(effects.antialiasing, Antialiasing::by_device);
    EXPECT_EQ(read("", effects), "");
    EXPECT_EQ(effects.antialiasing, Antialiasing::by_device) << "as it was";
    EXPECT_EQ(read("antialiasing = false\n", effects), "");
    EXPECT_EQ(effects.antialiasing, Antialiasing::off);
    for (const char* wrong : {"\"devices\"", "\"true\"", "2", "[true]"})
        EXPECT_EQ(read(std::string("antialiasing = ") + wrong + "\n", effects),
                  "d.toml:1: 'antialiasing' must be true, false or \"device\"");
}

TEST(ViewEffects, ThePanelsLightingHasItsColors) {
    ViewEffects effects;
    EXPECT_EQ(read("lighting = \"auto\"\nnight_color = \"#402010\"\n", effects), "");
    EXPECT_EQ(effects.lighting, PanelLighting::automatic);
    EXPECT_EQ(effects.night, (Color{0x40, 0x20, 0x10}));
    EXPECT_EQ(effects.dusk, (Color{0xB8, 0xAA, 0x98})) << "as it was";
}

TEST(ViewEffects, APictureForEachEye) {
    ViewEffects effects;
    EXPECT_EQ(effects.stereo.mode, StereoMode::none);
    EXPECT_EQ(read("[stereo]\nmode = \"anaglyph\"\nbase_m = 0.5\nscreen_m = 60\n", effects), "");
    EXPECT_EQ(effects.stereo.mode, StereoMode::anaglyph);
    EXPECT_EQ(effects.stereo.base_m, 0.5);
    EXPECT_EQ(effects.stereo.screen_m, 60);
    EXPECT_EQ(read("[stereo]\n", effects), "");
    EXPECT_EQ(effects.stereo.mode, StereoMode::side_by_side);
    EXPECT_NE(read("[stereo]\nmode = \"quad_buffer\"\n", effects).find("choose side_by_side or anaglyph"), std::string::npos);
}

TEST(ViewEffects, ClutterHasAView) {
    ViewEffects effects;
    EXPECT_EQ(effects.clutter, ClutterView::none);
    EXPECT_EQ(read("[clutter]\n", effects), "");
    EXPECT_EQ(effects.clutter, ClutterView::edges);
    EXPECT_EQ(read("[clutter]\nview = \"regions\"\n", effects), "");
    EXPECT_EQ(effects.clutter, ClutterView::regions);
}

TEST(ViewEffects, TheSaliencyMapHasAViewAndAScale) {
    ViewEffects effects;
    EXPECT_EQ(effects.saliency.view, SaliencyView::none);
    EXPECT_EQ(read("[saliency]\n", effects), "");
    EXPECT_EQ(effects.saliency.view, SaliencyView::heat);
    EXPECT_EQ(effects.saliency.scale, SaliencyScale::picture);
    EXPECT_EQ(read("[saliency]\nview = \"map\"\nscale = \"fixed\"\n", effects), "");
    EXPECT_EQ(effects.saliency.view, SaliencyView::map);
    EXPECT_EQ(effects.saliency.scale, SaliencyScale::fixed);
}

TEST(ViewEffects, WhatTakesAnEffectsPlace) {
    ViewEffects effects;
    EXPECT_EQ(read("[instead]\nsilhouettes = []\naerial_perspective = [\"haze\"]\n", effects), "");
    ASSERT_EQ(effects.instead.size(), 2u);
    EXPECT_EQ(effects.instead[0].effect.view(), "aerial_perspective") << "in the order of the alphabet";
    EXPECT_EQ(effects.instead[0].instead[0].view(), "haze");
    EXPECT_TRUE(effects.instead[1].instead.empty());
    EXPECT_NE(read("[instead]\nhaze = [\"a\", \"b\", \"c\"]\n", effects), "");
    EXPECT_NE(read("[instead]\nhaze = 1\n", effects), "");
}

TEST(ViewEffects, WhatHasNoMeaningIsRefused) {
    ViewEffects effects;
    for (const char* text :
         {"[depth_of_field]\nblur_px = 0\n", "[depth_of_field]\nblur_px = 9\n",
          "[depth_of_field]\nfocus_near_m = 5000\nfocus_far_m = 4000\n", "[depth_of_field]\nlayers = \"symbology\"\n",
          "[depth_of_field]\nfocus_role = \"storm\"\n", "antialiasing = 1\n", "lighting = \"quad\"\n", "[stereo]\nbase_m = 0\n",
          "[stereo]\nmode = \"vr\"\n", "[clutter]\nview = \"none\"\n", "[saliency]\n[clutter]\n", "[saliency]\nview = \"none\"\n",
          "[saliency]\nscale = 2\n", "bloom = true\n"})
        EXPECT_NE(read(text, effects).find("d.toml:"), std::string::npos) << text;
}

}  // namespace
}  // namespace tedavis::design::test_view_effects
