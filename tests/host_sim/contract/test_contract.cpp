#include "host_sim/contract/contract.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_contract {
namespace {

Contract read(const std::string& text) {
    const test_support::TemporaryFolder place;
    return read_contract(place.write("c.toml", text));
}

ContractCondition condition(const std::string& keys) { return read("[[condition]]\n" + keys).conditions.at(0); }

void refused(const std::string& keys, const std::string& words) {
    test_support::expect_user_error([&] { static_cast<void>(condition(keys)); }, words);
}

TEST(Contract, AConditionHasWhatTheFileSays) {
    const ContractCondition one = condition(
        "name = \"calm\"\nphases = [\"approach\", \"go_around.abort\"]\nfor_s = 2.5\noptional = true\nmeasure = \"clutter\"\n"
        "most = 0.2\nregion = \"every\"\ngrid = [4, 3]\n");
    EXPECT_EQ(one.name, "calm");
    EXPECT_EQ(one.phases, (std::vector<std::string>{"approach", "go_around.abort"}));
    EXPECT_TRUE(one.is_optional);
    EXPECT_TRUE(one.limit.is_most);
    EXPECT_EQ(one.limit.limit, 0.2);
    EXPECT_EQ(one.limit.for_s, 2.5);
    EXPECT_EQ(one.region, ClutterRegion::every);
    EXPECT_EQ(one.grid.count(), 12);
}

TEST(Contract, MeasuresOfTheSymbologysPaletteNeedALimit) {
    const ContractCondition contrast = condition("measure = \"symbology_contrast\"\nleast = 4.5\n");
    EXPECT_FALSE(contrast.limit.is_most);
    EXPECT_EQ(contrast.least_px, 12);
    EXPECT_TRUE(needs_layers(contrast));
    EXPECT_FALSE(needs_layers(condition("measure = \"symbology_difference\"\nleast = 6\n")));
    refused("measure = \"symbology_difference\"\nmost = 6\n", "least");
    refused("measure = \"symbology_contrast\"\nleast = 30\n", "least");
}

TEST(Contract, MeasuresHaveTheirOwnKeysAndDefaults) {
    EXPECT_EQ(condition("measure = \"clutter\"\nmost = 0.1\n").region, ClutterRegion::picture);
    const ContractCondition third = condition("measure = \"clutter\"\nmost = 0.1\nregion = \"lower right\"\n");
    EXPECT_EQ(third.grid.count(), 9);
    EXPECT_EQ(third.column + 10 * third.row, 22);
    const ContractCondition cell = condition("measure = \"clutter\"\nmost = 0.1\ncell = [8, 6]\n");
    EXPECT_EQ(cell.column + 10 * cell.row, 57);
    const ContractCondition share = condition("measure = \"saliency_share\"\nleast = 0.4\nwithout = [\"symbology\"]\n");
    EXPECT_TRUE(share.layer.empty()) << "that of the prioritized aspect";
    EXPECT_FALSE(share.limit.is_most);
    EXPECT_EQ(condition("measure = \"saliency_over_area\"\nleast = 2\nlayer = \"data\"\n").layer, "data");
    EXPECT_EQ(condition("measure = \"obstacle_rank\"\nmost = 5\n").focus_share, perception::kFocusShare);
    EXPECT_EQ(condition("measure = \"luminance_contrast\"\nleast = 3\nlayer = \"labels\"\n").least_px, 24);
    EXPECT_EQ(condition("measure = \"color_difference\"\nleast = 8\nbetween = [\"warnings\"]\n").between.size(), 1u);
}

TEST(Contract, AConditionWithoutANameIsCalledByWhatItMeasures) {
    EXPECT_EQ(
        condition("measure = \"luminance_contrast\"\nleast = 3\nlayer = \"labels\"\nphases = [\"cruise\", \"approach\"]\n").name,
        "luminance contrast of labels in cruise, approach");
}

TEST(Contract, APhaseHasItsSubPhases) {
    const ContractCondition one = condition("measure = \"clutter\"\nmost = 1\nphases = [\"approach\", \"go_around.abort\"]\n");
    for (const char* phase : {"approach", "approach.final", "go_around.abort"}) EXPECT_TRUE(applies_in(one, phase)) << phase;
    for (const char* phase : {"cruise", "approaching", "go_around", "go_around.replanning", ""})
        EXPECT_FALSE(applies_in(one, phase)) << phase;
    EXPECT_TRUE(applies_in(condition("measure = \"clutter\"\nmost = 1\n"), "unknown"));
}

TEST(Contract, WhatIsMeasuredByLayersSaysSo) {
    EXPECT_FALSE(needs_layers(condition("measure = \"clutter\"\nmost = 1\n")));
    EXPECT_FALSE(needs_layers(condition("measure = \"obstacle_rank\"\nmost = 5\n")));
    EXPECT_TRUE(needs_layers(condition("measure = \"obstacle_rank\"\nmost = 5\nwithout = [\"labels\"]\n")));
    EXPECT_TRUE(needs_layers(condition("measure = \"saliency_share\"\nleast = 0.5\n")));
    EXPECT_TRUE(needs_layers(condition("measure = \"luminance_contrast\"\nleast = 3\nlayer = \"labels\"\n")));
}

TEST(Contract, WhatIsWrongIsSaidWithItsLine) {
    refused("measure = \"beauty\"\nleast = 1\n", "c.toml:2: 'measure' must be one of: clutter, saliency_share");
    refused("most = 1\n", "'measure' is missing");
    refused("measure = \"clutter\"\n", "'most' is missing");
    refused("measure = \"clutter\"\nleast = 0.1\n", "'most' is missing");
    refused("measure = \"clutter\"\nmost = 0.1\nleast = 0.1\n", "c.toml:4: ");
    refused("measure = \"clutter\"\nmost = 0.1\nregion = \"beneath\"\n", "c.toml:4: 'region' must be picture, every, or a third");
    refused("measure = \"clutter\"\nmost = 0.1\ngrid = [4, 4]\n", "'grid' belongs to");
    refused("measure = \"clutter\"\nmost = 0.1\ncell = [9, 1]\n", "c.toml:4: 'cell' is no column and row of the grid");
    refused("measure = \"clutter\"\nmost = 0.1\ncell = [1.5, 1]\n", "'cell' is no column");
    refused("measure = \"clutter\"\nmost = 0.1\nphases = [\"apprach\"]\n", "c.toml:4: 'phases' names phases");
    refused("measure = \"saliency_share\"\nleast = 0.1\nlayer = \"clouds\"\n", "'layer' must be prioritized, terrain");
    refused("measure = \"saliency_share\"\nleast = 0.1\nlayer = \"data\"\nwithout = [\"data\"]\n",
            "'without' names other layers");
    refused("measure = \"luminance_contrast\"\nleast = 3\n", "'layer' is missing");
    refused("measure = \"luminance_contrast\"\nleast = 0.5\nlayer = \"labels\"\n", "'least'");
    refused("measure = \"color_difference\"\nleast = 3\n", "'between' must name groups");
    refused("measure = \"color_difference\"\nleast = 3\nbetween = [\"ground\"]\n", "'between' needs a second group");
    refused("measure = \"color_difference\"\nleast = 3\nbetween = [\"ground\", \"clouds\"]\n",
            "'between' names warnings, ground");
    refused("measure = \"obstacle_rank\"\nmost = 33\n", "'most'");
    refused("measure = \"clutter\"\nmost = 0.1\ncolour = 3\n", "colour");
    test_support::expect_user_error([] { static_cast<void>(read("title = \"t\"\n")); }, "has no [[condition]]");
    test_support::expect_user_error(
        [] {
            static_cast<void>(
                read("[[condition]]\nmeasure = \"clutter\"\nmost = 0.1\n[[condition]]\nmeasure = \"clutter\"\nmost = 0.2\n"));
        },
        "two conditions are called \"clutter\"");
    test_support::expect_user_error([] { static_cast<void>(read("[canny]\nsigma = 1\nlow = 9\nhigh = 3\n")); },
                                    "c.toml:3: 'low' must not be above 'high'");
}

TEST(Contract, EveryShippedOneIsSound) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shipped_root() + "/configs/contracts")) {
        if (entry.path().extension() != ".toml") continue;
        const Contract contract = read_contract(entry.path().string());
        EXPECT_FALSE(contract.title.empty()) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_contract
