#include "render_core/draw/symbology/key_legend.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_key_legend {
namespace {

using test_support::BatchStore;
using test_support::text_of;

/// Terrain of 0 to 2000 m with the warning bands, and these data; the key is shown.
SymbologyInput key_input(std::initializer_list<DataLegend> data = {}) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 1280, 720);
    input.legend_show = flight::LegendShow::key;
    input.legend.lowest = 0;
    input.legend.highest = 2000;
    input.data_legends = test_support::list_of(data);
    return input;
}

Layout layout_of(const SymbologyInput& input, std::uint32_t width = 1280, std::uint32_t height = 720) {
    return make_layout(width, height, 96, legend_need(input));
}

std::string key_text(const SymbologyInput& input, std::uint32_t width = 1280, std::uint32_t height = 720) {
    BatchStore store;
    build_legend(Painter(store.batch, layout_of(input, width, height)), input);
    EXPECT_EQ(store.batch.use().refused, 0u);
    return text_of(store.batch);
}

TEST(KeyLegend, NamesTheScalesThatDoNotExplainThemselves) {
    EXPECT_EQ(key_text(key_input()), "RELATIVEFT-2000+2000GROUNDELEVFT06562");
    SymbologyInput input = key_input({test_support::wind()});
    EXPECT_EQ(key_text(input), "RELATIVEFT-2000+2000WINDM/S020GROUNDELEVFT06562") << "data before the terrain";
    input.legend.bands = input.legend.tint = false;
    EXPECT_EQ(key_text(input), "WINDM/S020");
    input.data_legends.clear();
    EXPECT_EQ(key_text(input), "");
}

TEST(KeyLegend, LeavesOutNamesOfClassesSymbolsUncertaintyAndSources) {
    DataLegend symbols;
    symbols.has_scale = false;
    symbols.title = "SYMBOLS";
    SymbologyInput input = key_input({test_support::land_cover(3), test_support::wind(), symbols});
    input.legend.bands = input.legend.tint = false;
    EXPECT_EQ(key_text(input), "WINDM/S020");
    input.legend_show = flight::LegendShow::whole;
    EXPECT_NE(key_text(input).find("LANDCOVER"), std::string::npos) << "the control: the whole legend has them";
}

TEST(KeyLegend, NumbersOfClassesStandWhereTheClassesEnd) {
    const KeyEntries three = key_entries(key_input({test_support::classed_wind(3)}));
    const auto entry =
        std::find_if(three.begin(), three.end(), [](const KeyEntry& e) { return e.titles[0].view() == "WIND M/S"; });
    ASSERT_NE(entry, three.end());
    EXPECT_EQ(entry->colors.size(), 4u);
    ASSERT_EQ(entry->numbers.size(), 2u);
    EXPECT_EQ(entry->numbers[0].text.view(), "5");
    EXPECT_EQ(entry->numbers[0].after, 1u);
    EXPECT_EQ(entry->numbers[1].text.view(), "15");
    EXPECT_EQ(entry->numbers[1].after, 3u);
}

TEST(KeyLegend, TheHighestBandBeginsAtItsNumber) {
    const SymbologyInput input = key_input();
    const KeyEntry bands = key_entries(input)[0];
    ASSERT_EQ(bands.colors.size(), input.legend.warning_bands.size());
    EXPECT_EQ(bands.numbers[0].after, 0u);
    EXPECT_EQ(bands.numbers[1].after, bands.colors.size() - 1);
}

TEST(KeyLegend, StaleDataSayTheirAgeInAmberAndComeFirst) {
    DataLegend stale = test_support::wind();
    stale.title = "GUST";
    stale.is_stale = true;
    const SymbologyInput input = key_input({test_support::wind(), stale});
    const KeyEntries entries = key_entries(input);
    ASSERT_EQ(entries.size(), 4u);
    EXPECT_EQ(entries[1].titles[0].view(), "GUST M/S STALE 12 MIN");
    EXPECT_TRUE(entries[1].is_amber);
    EXPECT_FALSE(entries[2].is_amber);
    EXPECT_NE(key_text(input).find("STALE12MIN"), std::string::npos);
    DataLegend unknown = test_support::wind();
    unknown.has_age = false;
    EXPECT_EQ(key_entries(key_input({unknown}))[1].titles[0].view(), "WIND M/S AGE ?");
}

/// Without its name one member would be taken for the mean.
TEST(KeyLegend, AMemberThatIsShownInTurnIsNamedAlways) {
    DataLegend member = test_support::wind();
    member.part = "MEMBER 3/9";
    SymbologyInput input = key_input({test_support::wind(), member});
    EXPECT_EQ(key_entries(input)[0].titles[0].view(), "MEMBER 3/9 WIND M/S");
    input.legend_show = flight::LegendShow::none;
    ASSERT_EQ(key_entries(input).size(), 1u);
    EXPECT_NE(key_text(input).find("MEMBER3/9"), std::string::npos);
    input.data_legends = test_support::list_of({test_support::wind()});
    EXPECT_EQ(key_text(input), "") << "the control: nothing else";
}

TEST(KeyLegend, NothingStandsInARecoveryPictureOrAgainstTheDesign) {
    SymbologyInput input = key_input({test_support::wind()});
    input.decisions.unusual_attitude = true;
    EXPECT_EQ(key_text(input), "");
    input = key_input({test_support::wind()});
    input.shown.legend = false;
    EXPECT_EQ(key_text(input), "");
}

TEST(KeyLegend, EachColorOfAScaleIsThere) {
    SymbologyInput input = key_input({test_support::classed_wind(4)});
    input.legend.bands = input.legend.tint = false;
    BatchStore store;
    build_legend(Painter(store.batch, layout_of(input)), input);
    std::set<std::tuple<int, int, int>> drawn;
    for (const QuadVertex& vertex : store.batch.vertices()) drawn.insert({vertex.rgba[0], vertex.rgba[1], vertex.rgba[2]});
    for (std::size_t n = 0; n < 5; ++n) {
        const design::Color color = color_of_class(test_support::classed_wind(4).scale, n);
        EXPECT_EQ(drawn.count({color.red, color.green, color.blue}), 1u) << n;
    }
}

TEST(KeyLegend, StaysWithinItsCellsOnEveryScreen) {
    DataLegend far = test_support::wind();
    far.title = "VERY LONG NAME OF A QUANTITY";
    far.factor = -12345;
    const SymbologyInput input = key_input({test_support::wind(), far, test_support::classed_wind(9)});
    for (const auto& [width, height] :
         {std::pair{240u, 320u}, {320u, 240u}, {480u, 272u}, {480u, 800u}, {640u, 480u}, {3840u, 2160u}}) {
        BatchStore store;
        const Layout layout = layout_of(input, width, height);
        build_legend(Painter(store.batch, layout), input);
        ASSERT_GT(store.batch.vertices().size(), 0u);
        const Rect room = layout.key.box.shrunk(-1.5f);
        for (const QuadVertex& vertex : store.batch.vertices())
            EXPECT_TRUE(room.contains(Point{vertex.x, vertex.y})) << width << " " << vertex.x << " " << vertex.y;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_key_legend
