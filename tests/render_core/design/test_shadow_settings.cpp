#include "render_core/design/shadow_settings.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::design::test_shadow_settings {
namespace {

using scene::LayerRole;

/// Empty where the text is accepted.
std::string read(const std::string& text, ShadowSettings& shadows) {
    base::ConfigReader reader(text, "d.toml");
    read_shadows(reader.root(), shadows);
    return reader.finish() ? std::string() : std::string(reader.error().message.view());
}

TEST(ShadowSettings, ThingsCastThemUnlessADesignSaysWhat) {
    ShadowSettings shadows;
    EXPECT_FALSE(shadows.is_any());
    EXPECT_EQ(read("on_ground = 0.5\n", shadows), "");
    EXPECT_TRUE(shadows.is_any());
    EXPECT_EQ(shadows.on_ground, 0.5);
    for (const LayerRole thing : {LayerRole::trajectory, LayerRole::obstacle, LayerRole::storm_cell})
        EXPECT_TRUE(shadows.casters.has(thing));
    for (const LayerRole other : {LayerRole::airspace, LayerRole::no_go, LayerRole::wind, LayerRole::runway})
        EXPECT_FALSE(shadows.casters.has(other));
    EXPECT_EQ(read("casters = [\"no_go\", \"wind\"]\n", shadows), "");
    EXPECT_TRUE(shadows.casters.has(LayerRole::no_go));
    EXPECT_TRUE(shadows.casters.has(LayerRole::wind));
    EXPECT_FALSE(shadows.casters.has(LayerRole::obstacle));
}

TEST(ShadowSettings, WhatHasNoMeaningIsRefused) {
    ShadowSettings shadows;
    for (const char* text : {"on_ground = 1.5\n", "in_air = -1\n", "steps = 100\n", "casters = [\"clouds\"]\n", "casters = []\n",
                             "in_the_sea = 1\n"})
        EXPECT_NE(read(text, shadows), "") << text;
}

}  // namespace
}  // namespace tedavis::design::test_shadow_settings
