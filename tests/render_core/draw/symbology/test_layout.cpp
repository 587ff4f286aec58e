#include "render_core/draw/symbology/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tedavis::draw::test_layout {
namespace {

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{320, 240},  {240, 320},   {640, 480},   {480, 640},   {800, 480},   {1024, 768},
                               {768, 1024}, {1080, 1920}, {1920, 1080}, {2560, 1080}, {1080, 2560}, {3840, 2160}};

/// Without terrain's legend, with an ordinary one, with the highest; one to four legends of data; each without maps beside the
/// picture, with one and with nine.
std::vector<LegendNeed> legend_needs() {
    std::vector<LegendNeed> needs(1);
    for (const auto& [most, least] : {std::pair{0.0f, 0.0f}, {12.6f, 7.6f}, {24.8f, 19.9f}})
        for (std::size_t entries = 1; entries <= 4; ++entries) {
            const auto count = static_cast<float>(entries);
            needs.push_back({most, least, {entries, 13 * count - 0.3f, 2.9f * count - 0.3f}, {}});
        }
    const std::vector<LegendNeed> without = needs;
    for (const AdjacentNeed maps : {AdjacentNeed{1, 5}, {9, 2.5f}})
        for (LegendNeed need : without) {
            need.adjacent = maps;
            needs.push_back(need);
        }
    // Without columns: none of the legends, and keys of all lengths, with maps beside the picture too.
    for (std::size_t entries = 0; entries <= 7; ++entries)
        for (const std::uint32_t maps : {0u, 1u, 9u}) {
            LegendNeed need;
            need.key_entries = entries;
            need.adjacent = {maps, maps == 1 ? 5.0f : 2.5f};
            needs.push_back(need);
        }
    needs.emplace_back();
    needs.back().keeps_column = true;
    return needs;
}

/// All that are not empty; the legend of a terrain that needs none may be, and is without any legends.
std::vector<std::pair<std::string, Rect>> boxes_of(const Layout& layout, const LegendNeed& need) {
    std::vector<std::pair<std::string, Rect>> boxes;
    for (const LayoutBox& entry : kLayoutBoxes) {
        const Rect& box = layout.*entry.box;
        const bool may_be_empty = entry.box == &Layout::legend && (need.terrain_most == 0 || !layout.has_legend_rows);
        EXPECT_TRUE(!box.empty() || may_be_empty) << entry.name;
        if (!box.empty()) boxes.emplace_back(entry.name, box);
    }
    for (const Rect& area : layout.data_legends)
        if (!area.empty()) boxes.emplace_back("data legends", area);
    EXPECT_FALSE(layout.air.overlaps(layout.key.box)) << "the key and the air";
    if (!layout.key.box.empty()) boxes.emplace_back("key", layout.key.box);
    if (!layout.adjacent.empty()) boxes.emplace_back("adjacent", layout.adjacent);
    return boxes;
}

TEST(Layout, NoBoxOverlapsAnotherOrLeavesTheScreen) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0})
            for (const LegendNeed& need : legend_needs()) {
                const Layout layout = make_layout(screen.width, screen.height, dpi, need);
                const std::string what = std::to_string(screen.width) + "x" + std::to_string(screen.height) + " " +
                                         std::to_string(dpi) + " with " + std::to_string(need.data.entries);
                const auto boxes = boxes_of(layout, need);
                for (std::size_t i = 0; i < boxes.size(); ++i) {
                    EXPECT_TRUE(layout.screen.shrunk(-0.01f).contains(boxes[i].second)) << boxes[i].first << " " << what;
                    for (std::size_t j = i + 1; j < boxes.size(); ++j)
                        EXPECT_FALSE(boxes[i].second.shrunk(0.01f).overlaps(boxes[j].second))
                            << boxes[i].first << " and " << boxes[j].first << " " << what;
                }
            }
}

TEST(Layout, TheKeyTakesAtMostATwentiethOfThePictureAndCountsWhatItLeavesOut) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0})
            for (std::size_t entries = 1; entries <= 7; ++entries) {
                LegendNeed need;
                need.key_entries = entries;
                const Layout layout = make_layout(screen.width, screen.height, dpi, need);
                const std::string what = std::to_string(screen.width) + "x" + std::to_string(screen.height);
                const float picture = layout.screen.width * layout.screen.height;
                EXPECT_GE(layout.key.shown, 1u) << what << " " << dpi;
                EXPECT_EQ(layout.key.shown + layout.key.cut, entries);
                EXPECT_LE(layout.key.box.width * layout.key.box.height, 0.05f * picture) << what << " " << dpi;
                EXPECT_FALSE(layout.key.box.overlaps(layout.airspeed) || layout.key.box.overlaps(layout.heading)) << what;
            }
}

TEST(Layout, WhereRowsOfLegendsWouldTouchTheKeyStandsInTheirPlace) {
    LegendNeed need{12.6f, 7.6f, {2, 25.7f, 5.5f}, {}};
    need.keeps_column = true;
    need.key_entries = 3;
    const Layout small = make_layout(320, 240, 96, need), large = make_layout(640, 480, 96, need);
    EXPECT_FALSE(small.has_legend_rows);
    EXPECT_TRUE(small.legend.empty() && small.data_legends[0].empty());
    EXPECT_GE(small.key.shown, 1u);
    EXPECT_TRUE(large.has_legend_rows);
    EXPECT_FALSE(large.legend.empty() || large.data_legends[0].empty());
    EXPECT_EQ(large.key.shown, 0u);
}

TEST(Layout, WithoutColumnsTheAttitudeAndTheRoseHaveTheirRoom) {
    for (const Screen& screen : kScreens) {
        LegendNeed whole;
        whole.keeps_column = true;
        const Layout with = make_layout(screen.width, screen.height, 96, whole),
                     without = make_layout(screen.width, screen.height, 96);
        EXPECT_TRUE(without.legend.empty());
        EXPECT_EQ(with.has_legend_rows, with.text_px >= kMinLegendText_px);
        if (!with.has_legend_rows) continue;
        EXPECT_GT(without.attitude.width, with.attitude.width + 4.9f * with.text_px);
        EXPECT_NEAR(without.attitude.right(), with.attitude.right(), 0.01f);
        EXPECT_GE(without.heading.width, with.heading.width);
        EXPECT_NEAR(without.heading.center().x, without.screen.center().x, 0.01);
    }
}

TEST(Layout, MapsBesideThePictureGiveWayToLegendsAndNothingElseDoes) {
    for (const Screen& screen : kScreens)
        for (const AdjacentNeed maps : {AdjacentNeed{1, 5}, {4, 2.5f}, {9, 2.5f}, {16, 1.5f}}) {
            const Layout layout = make_layout(screen.width, screen.height, 96, {3.6f, 3.6f, {1, 13, 2.9f}, maps}),
                         bare = make_layout(screen.width, screen.height, 96, {1, 1, {}, {}});
            if (!layout.has_legend_rows) continue;
            ASSERT_FALSE(layout.adjacent.empty()) << screen.width << "x" << screen.height << " " << maps.maps;
            EXPECT_GE(layout.data_legends[0].height, 2.89f * layout.text_px);
            for (const LayoutBox& entry : kLayoutBoxes) {
                if (entry.box == &Layout::legend || entry.box == &Layout::attitude || entry.box == &Layout::heading) continue;
                EXPECT_EQ((bare.*entry.box).width, (layout.*entry.box).width) << entry.name;
                EXPECT_EQ((bare.*entry.box).height, (layout.*entry.box).height) << entry.name;
            }
            EXPECT_TRUE(make_layout(screen.width, screen.height, 96, {24.8f, 19.9f, {4, 52, 11.3f}, maps}).adjacent.empty() ||
                        layout.screen.height > 30 * layout.text_px)
                << "no room";
        }
}

TEST(Layout, MapsBecomeSmallerBeforeTheyGo) {
    const AdjacentNeed nine{9, 2.5f};
    const Layout roomy = make_layout(1280, 960, 96, {3.6f, 3.6f, {1, 13, 2.9f}, nine}),
                 tight = make_layout(1280, 960, 96, {12.6f, 7.6f, {3, 39, 8.4f}, nine});
    ASSERT_FALSE(tight.adjacent.empty());
    EXPECT_LT(tight.adjacent.height, roomy.adjacent.height);
    EXPECT_LT(plan_adjacent(tight.adjacent, 9, 32).side_px, plan_adjacent(roomy.adjacent, 9, 32).side_px);
}

TEST(Layout, WithoutLegendsOfDataNothingMakesRoomForThem) {
    for (const Screen& screen : kScreens) {
        LegendNeed nothing;
        nothing.keeps_column = true;
        const Layout bare = make_layout(screen.width, screen.height, 96, nothing),
                     terrain = make_layout(screen.width, screen.height, 96, {20, 15, {}, {}});
        for (const LayoutBox& entry : kLayoutBoxes) {
            EXPECT_EQ((bare.*entry.box).width, (terrain.*entry.box).width) << entry.name;
            EXPECT_EQ((bare.*entry.box).height, (terrain.*entry.box).height) << entry.name;
        }
        for (const Rect& area : terrain.data_legends) EXPECT_TRUE(area.empty());
    }
}

TEST(Layout, LegendsOfDataAlwaysHaveRoomForTheirScales) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0})
            for (const LegendNeed& need : legend_needs()) {
                const Layout layout = make_layout(screen.width, screen.height, dpi, need);
                const float t = layout.text_px;
                if (!layout.has_legend_rows) continue;
                std::size_t places = 0;
                for (const Rect& area : layout.data_legends)
                    places += area.width > 8 * t ? 3 : static_cast<std::size_t>((area.height / t + 0.31f) / 2.9f);
                EXPECT_GE(places, need.data.entries) << screen.width << "x" << screen.height << " " << dpi;
                EXPECT_GE(layout.legend.height + 0.01f, need.data.entries > 0 ? need.terrain_least * t : 0);
                EXPECT_TRUE(layout.attitude.shrunk(5.8f * t).contains(layout.screen.center()));
                EXPECT_GE(layout.heading.width, 11.9f * t);
            }
}

TEST(Layout, TheViewsMiddleLiesInsideTheAttitudeWithRoomForThePitch) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const Point center = layout.screen.center();
        EXPECT_TRUE(layout.attitude.shrunk(6 * layout.text_px).contains(center));
        EXPECT_NEAR(layout.heading.center().x, center.x, 0.01);
        EXPECT_GE(layout.heading.width, 12 * layout.text_px);
    }
}

/// The strip of headings has become a compass rose: it is higher, and the attitude ends above it.
TEST(Layout, TheRoseHasTheLowestPartOfThePictureBelowTheAttitude) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0})
            for (const LegendNeed& need : legend_needs()) {
                const Layout layout = make_layout(screen.width, screen.height, dpi, need);
                const float t = layout.text_px;
                EXPECT_GE(layout.heading.height, 5.7f * t) << screen.width << "x" << screen.height << " " << dpi;
                EXPECT_LE(layout.heading.height, 0.301f * layout.screen.height);
                EXPECT_LE(layout.attitude.bottom(), layout.heading.y);
                const bool is_below_columns = layout.heading.y > layout.airspeed.bottom();
                EXPECT_EQ(is_below_columns, screen.width == 240) << "where the columns leave it no room";
                const float foot = is_below_columns ? layout.baro_setting.y - 0.3f * t : layout.baro_setting.bottom();
                EXPECT_NEAR(layout.heading.bottom(), foot, 0.01);
                EXPECT_NEAR(layout.heading.center().x, layout.screen.center().x, 0.01);
            }
}

TEST(Layout, TheVerticalDeviationIsBesideTheAltitudeAtTheHeightOfTheMiddle) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const Rect& box = layout.vertical_deviation;
        const Point center = layout.screen.center();
        EXPECT_NEAR(box.center().y, layout.screen.center().y, 0.01);
        EXPECT_GE(box.height, 5 * layout.text_px);
        EXPECT_TRUE(layout.attitude.shrunk(-0.01f).contains(box));
        EXPECT_LT(layout.altitude.x - box.right(), 0.5f * layout.text_px);
        EXPECT_GT(box.x - center.x, 5.2f * layout.text_px) << "beside the aircraft's symbol";
    }
}

TEST(Layout, TheLegendHasTheRoomThatItCountsOn) {
    for (const Screen& screen : kScreens)
        for (double dpi : {60.0, 96.0, 160.0, 300.0}) {
            LegendNeed whole;
            whole.keeps_column = true;
            const Layout layout = make_layout(screen.width, screen.height, dpi, whole);
            if (!layout.has_legend_rows) continue;
            EXPECT_GE(layout.legend.width, 4.99f * layout.text_px);
            EXPECT_GE(layout.legend.height, 19 * layout.text_px) << screen.width << "x" << screen.height << " " << dpi;
        }
}

TEST(Layout, TextGrowsWithTheScreenAndWithTheDensityOfThePanel) {
    EXPECT_NEAR(make_layout(1920, 1440, 96).text_px / make_layout(640, 480, 96).text_px, 3, 0.01);
    EXPECT_GT(make_layout(1920, 1080, 400).text_px, make_layout(1920, 1080, 96).text_px);
    for (const Screen& screen : kScreens) {
        float last = 0;
        for (double dpi : {60.0, 100.0, 200.0, 400.0}) {
            const float text = make_layout(screen.width, screen.height, dpi).text_px;
            EXPECT_GE(text, last);
            last = text;
        }
    }
}

TEST(Layout, ScalingTheScreenScalesEveryBox) {
    const Layout small = make_layout(640, 480, 96), large = make_layout(1280, 960, 192);
    for (const LayoutBox& entry : kLayoutBoxes) {
        const Rect &a = small.*entry.box, &b = large.*entry.box;
        EXPECT_NEAR(b.x, 2 * a.x, 0.01);
        EXPECT_NEAR(b.y, 2 * a.y, 0.01);
        EXPECT_NEAR(b.width, 2 * a.width, 0.01);
        EXPECT_NEAR(b.height, 2 * a.height, 0.01);
    }
}

}  // namespace
}  // namespace tedavis::draw::test_layout
