#include "render_core/effects/effect_catalogue.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "render_core/effects/quality_ladder.hpp"
#include "tests/support/device_files.hpp"

namespace tedavis::effects::test_effect_catalogue {
namespace {

const char* name_of(Need need) {
    return need == Need::depth24_target           ? "24-bit depth off screen"
           : need == Need::half_float_texture     ? "textures of half floats"
           : need == Need::second_picture         ? "a second picture off screen, ES 3"
           : need == Need::shadow_map             ? "a map of shadows, ES 3"
           : need == Need::shadow_map_and_picture ? "a map of shadows, a second picture off screen, ES 3"
           : need == Need::picture_copy           ? "copies of what was drawn, ES"
                                                  : "";
}

std::string rung_of(Effect effect) { return given_up_from(effect) == kNever ? "" : std::to_string(given_up_from(effect)); }

/// The table of the module's README, from the code.
std::string table() {
    std::ostringstream text;
    text << "| effect | shows | needs | bound of what is seen | cost | grows with | given up from rung | in its place "
            "|\n|---|---|---|---|---|---|---|---|\n";
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectEntry& entry = entry_of(static_cast<Effect>(n));
        text << "| `" << entry.name << "` | " << kContributionNames[static_cast<std::size_t>(entry.contribution)] << " | "
             << name_of(entry.need) << " | " << entry.bound << " | " << entry.cost << " | "
             << kCostThingNames[static_cast<std::size_t>(thing_of(entry.effect))] << " | " << rung_of(entry.effect) << " | ";
        for (const Effect replacement : entry.replacements)
            if (replacement != Effect::count_) text << "`" << entry_of(replacement).name << "` ";
        text << "|\n";
    }
    return text.str();
}

TEST(EffectCatalogue, IsThePageOfTheModule) {
    const std::string page = test_support::source_file("render_core/effects/README.md");
    EXPECT_NE(page.find(table()), std::string::npos) << "write this table into render_core/effects/README.md:\n" << table();
}

TEST(EffectCatalogue, NamesAreUniqueAndFoundAgain) {
    std::set<std::string_view> names;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectEntry& entry = entry_of(static_cast<Effect>(n));
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
        EXPECT_EQ(effect_of(entry.name), static_cast<Effect>(n));
    }
    EXPECT_EQ(effect_of("aurora"), Effect::count_);
    EXPECT_EQ(effect_of(""), Effect::count_);
}

/// What stands in last needs nothing. For content it cannot be taken away either: nothing is lost that others show.
TEST(EffectCatalogue, WhatStandsInIsAlwaysPossible) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectEntry& entry = entry_of(static_cast<Effect>(n));
        for (const Effect replacement : entry.replacements) {
            if (replacement == Effect::count_) continue;
            const bool is_last = entry.replacements.back() == Effect::count_ || replacement == entry.replacements.back();
            EXPECT_TRUE(!is_last || entry_of(replacement).need == Need::nothing) << entry.name;
            if (entry.contribution != Contribution::content) continue;
            EXPECT_FALSE(entry_of(replacement).may_be_forbidden);
        }
    }
    for (const Effect always : {Effect::terrain, Effect::warning_colors}) EXPECT_FALSE(entry_of(always).may_be_forbidden);
}

TEST(EffectCatalogue, OnlyEffectsOnColourOrPlacesHaveABound) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectEntry& entry = entry_of(static_cast<Effect>(n));
        EXPECT_EQ(entry.bound.empty(), entry.contribution == Contribution::content) << entry.name;
    }
}

TEST(EffectCatalogue, ADeviceHasWhatItsFileSays) {
    DeviceCapability device;
    EXPECT_TRUE(has(device, Need::depth24_target));
    device.depth24_targets = false;
    EXPECT_FALSE(has(device, Need::depth24_target));
    EXPECT_TRUE(has(device, Need::nothing));
    EXPECT_TRUE(has(device, Need::picture_copy));
    device.gl.calls = CallClass::es3;
    EXPECT_TRUE(has(device, Need::half_float_texture));
    EXPECT_FALSE(has(device, Need::second_picture));
    device.off_screen_pictures = 2;
    EXPECT_TRUE(has(device, Need::second_picture));
    EXPECT_FALSE(has(device, Need::shadow_map));
    device.shadow_map_px = 1024;
    EXPECT_TRUE(has(device, Need::shadow_map));
    EXPECT_TRUE(has(device, Need::shadow_map_and_picture));
    device.gl.calls = CallClass::sc2;
    EXPECT_FALSE(has(device, Need::shadow_map));
    EXPECT_FALSE(has(device, Need::half_float_texture));
    EXPECT_FALSE(has(device, Need::second_picture));
    EXPECT_FALSE(has(device, Need::picture_copy));
    EXPECT_EQ(lack_of(Need::half_float_texture), "the device has no textures of half floats");
    EXPECT_EQ(lack_of(Need::depth24_target), "the device has no 24-bit depth off screen");
}

}  // namespace
}  // namespace tedavis::effects::test_effect_catalogue
