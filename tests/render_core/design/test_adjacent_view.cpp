#include "render_core/design/adjacent_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/display/grey_palettes.hpp"

namespace tedavis::design::test_adjacent_view {
namespace {

struct Read {
    AdjacentView view;
    std::string fault;
};
Read read(const std::string& text) {
    test_support::GreyPalettes palettes;
    base::ConfigReader reader(text, "d.toml");
    Read result;
    read_adjacent_view(reader.root().section("adjacent"), palettes, result.view);
    if (!reader.finish()) result.fault = std::string(reader.error().message.view());
    return result;
}

constexpr const char* kMin = "[adjacent]\nlayer = 'gusts'\nattribute = 'gust'\npalette = 'grey'\n";

TEST(AdjacentView, EveryKeyIsRead) {
    const Read whole = read(
        "[adjacent]\nrole = 'wind'\nattribute = 'speed'\npalette = 'grey'\nbreaks = [1, 2]\nshows = 'members'\nrange_m = "
        "9000\nsize = "
        "3\ncells = 10\nheight_m = 500\n");
    EXPECT_EQ(whole.fault, "");
    EXPECT_TRUE(whole.view.is_shown);
    EXPECT_TRUE(whole.view.layer.empty());
    EXPECT_EQ(whole.view.role, scene::LayerRole::wind);
    EXPECT_EQ(whole.view.attribute.view(), "speed");
    EXPECT_EQ(whole.view.scale.breaks.size(), 2u);
    EXPECT_EQ(whole.view.shows, AdjacentShows::members);
    EXPECT_EQ(whole.view.range_m, 9000);
    EXPECT_EQ(whole.view.size, 3);
    EXPECT_EQ(whole.view.cells, 10u);
    EXPECT_EQ(whole.view.height_m, 500);
}

TEST(AdjacentView, LittleHasToBeSaid) {
    const Read least = read(kMin);
    EXPECT_EQ(least.fault, "");
    EXPECT_EQ(least.view.shows, AdjacentShows::uncertainty);
    EXPECT_EQ(least.view.layer.view(), "gusts");
    EXPECT_EQ(least.view.size, 5);
    EXPECT_TRUE(std::isnan(least.view.height_m));
    EXPECT_NEAR(read(std::string(kMin) + "shows = 'members'\n").view.size, 2.5, 1e-9) << "of several smaller ones";
    EXPECT_FALSE(read("").view.is_shown) << "nothing is shown that is not asked for";
    EXPECT_FALSE(read(std::string(kMin) + "enabled = false\n").view.is_shown);
}

TEST(AdjacentView, FaultsNameWhatIsWrong) {
    EXPECT_NE(read("[adjacent]\nlayer = 'gusts'\nattribute = 'gust'\npalette = 'kinds'\n").fault.find("maps show numbers"),
              std::string::npos);
    const auto fault = [](const std::string& more) { return read(kMin + more).fault; };
    EXPECT_NE(fault("role = 'wind'\n").find("give one of them"), std::string::npos);
    EXPECT_NE(read("[adjacent]\nattribute = 'a'\npalette = 'grey'\n").fault.find("give one of them"), std::string::npos);
    EXPECT_NE(fault("shows = 'noise'\n").find("shows"), std::string::npos);
    EXPECT_NE(fault("cells = 26\n").find("cells"), std::string::npos);
    EXPECT_NE(fault("size = 5.5\n").find("size"), std::string::npos);
    EXPECT_NE(fault("range_m = 0\n").find("range_m"), std::string::npos);
    EXPECT_NE(fault("side = 'left'\n").find("side"), std::string::npos) << "keys that nobody reads";
    EXPECT_NE(read("[adjacent]\nlayer = 'a'\nattribute = 'b'\n").fault, "") << "without a palette";
}

}  // namespace
}  // namespace tedavis::design::test_adjacent_view
