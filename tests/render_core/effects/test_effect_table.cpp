#include "render_core/effects/effect_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "render_core/effects/quality_level.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/generated_page.hpp"

namespace tedavis::effects::test_effect_table {
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

/// The table of the module's README, from the code.
std::string table() {
    std::ostringstream text;
    text << "| effect | asked for by | shows | needs | bound of what is seen | cost | grows with | may be given up | in its "
            "place "
            "|\n|---|---|---|---|---|---|---|---|---|\n";
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        text << "| `" << row.name << "` | " << (row.design_key.empty() ? "" : "`" + std::string(row.design_key) + "`") << " | "
             << kContributionNames[static_cast<std::size_t>(row.contribution)] << " | " << name_of(row.need) << " | " << row.bound
             << " | " << row.cost << " | " << kCostThingNames[static_cast<std::size_t>(thing_of(row.effect))] << " | "
             << (row.may_be_given_up ? "yes" : "") << " | ";
        for (const Effect replacement : row.replacements)
            if (replacement != Effect::count_) text << "`" << row_of(replacement).name << "` ";
        text << "|\n";
    }
    return text.str();
}

TEST(EffectTable, IsThePageOfTheModule) { test_support::expect_page_part("render_core/effects/README.md", "effects", table()); }

TEST(EffectTable, NamesAreUniqueAndFoundAgain) {
    std::set<std::string_view> names;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(effect_of(row.name), static_cast<Effect>(n));
    }
    EXPECT_EQ(effect_of("aurora"), Effect::count_);
    EXPECT_EQ(effect_of(""), Effect::count_);
}

/// What stands in last needs nothing. For content it cannot be taken away either: nothing is lost that others show.
TEST(EffectTable, WhatStandsInIsAlwaysPossible) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        for (const Effect replacement : row.replacements) {
            if (replacement == Effect::count_) continue;
            const bool is_last = row.replacements.back() == Effect::count_ || replacement == row.replacements.back();
            EXPECT_TRUE(!is_last || row_of(replacement).need == Need::nothing) << row.name;
            if (row.contribution != Contribution::content) continue;
            EXPECT_FALSE(row_of(replacement).may_be_forbidden);
        }
    }
    for (const Effect always : {Effect::terrain, Effect::warning_colors}) EXPECT_FALSE(row_of(always).may_be_forbidden);
}

/// What is asked for can be left out again, and says when it is called for.
TEST(EffectTable, RowsAreWhole) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        EXPECT_FALSE(row.cost.empty()) << row.name;
        EXPECT_EQ(row.is_asked != nullptr, row.request != nullptr) << row.name;
        EXPECT_TRUE(row.take_out != nullptr || row.effect == Effect::terrain || row.request == nullptr) << row.name;
        if (row.ask == nullptr) continue;
        design::DesignSettings design;
        row.ask(design);
        EXPECT_TRUE(row.is_asked(design)) << row.name;
        row.take_out(design);
        EXPECT_FALSE(row.is_asked(design)) << row.name;
    }
}

/// As "[table] key", or "[table]" where all its keys ask for it; a test of designs holds their page to what is read.
TEST(EffectTable, KeysAreThoseOfDesigns) {
    const std::string page = test_support::source_file("configs/designs/README.md");
    std::size_t keys = 0;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        std::istringstream words(std::string(row_of(static_cast<Effect>(n)).design_key));
        for (std::string word; words >> word; ++keys) {
            if (word.back() == ',') word.pop_back();
            EXPECT_NE(page.find("`" + word + "`"), std::string::npos) << word;
        }
    }
    EXPECT_GT(keys, 2 * 18u);
}

TEST(EffectTable, OnlyEffectsOnColorOrPlacesHaveABound) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        EXPECT_EQ(row.bound.empty(), row.contribution == Contribution::content) << row.name;
    }
}

}  // namespace
}  // namespace tedavis::effects::test_effect_table
