#include "render_core/draw/symbology/data_legend.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/data_legend_samples.hpp"

namespace tedavis::draw::test_data_legend {
namespace {

using test_support::area_of;
using test_support::BatchStore;
using test_support::classed_wind;
using test_support::kMinute_ns;
using test_support::land_cover;
using test_support::list_of;
using test_support::text_in;
using test_support::text_of;
using test_support::wind;

TEST(DataLegend, TimeAndAgeSayHowOldDataAreOrHowFarAhead) {
    DataLegend legend = wind();
    const auto text = [&](std::int64_t age_ns) {
        legend.age = {age_ns};
        return std::string(time_and_age(legend).view());
    };
    EXPECT_EQ(text(0), "13:05Z 0 MIN");
    EXPECT_EQ(text(12 * kMinute_ns + 59), "13:05Z 12 MIN");
    EXPECT_EQ(text(-40 * kMinute_ns), "13:05Z IN 40 MIN");
    legend.is_forecast = true;
    EXPECT_EQ(text(12 * kMinute_ns), "13:05Z +12 MIN");
    legend.is_forecast = false;
    EXPECT_EQ(text(100 * kMinute_ns), "13:05Z 1 H");
    EXPECT_EQ(text(50 * 60 * kMinute_ns), "13:05Z 2 D");
    legend.is_stale = true;
    EXPECT_EQ(text(45 * kMinute_ns), "13:05Z STALE 45 MIN");
    legend.has_age = false;
    EXPECT_EQ(text(0), "13:05Z AGE ?");
    legend.data_time_ns = -kMinute_ns;
    EXPECT_EQ(text(0), "23:59Z AGE ?");
    legend.has_time = false;
    EXPECT_EQ(text(0), "");
}

/// One to four of a continuous scale, classes, and names.
std::vector<DataLegends> mixed_lists() {
    std::vector<DataLegends> lists;
    for (const auto& entries : {std::initializer_list<DataLegend>{wind()},
                                {classed_wind(15), land_cover(16)},
                                {wind(), classed_wind(5), land_cover(3)},
                                {classed_wind(4), wind(), land_cover(16), wind()}})
        lists.push_back(list_of(entries));
    return lists;
}

/// An entry without a scale.
DataLegend signs(std::size_t rows) {
    DataLegend legend;
    legend.has_scale = false;
    legend.title = "SYMBOLS";
    for (std::size_t n = 0; n < rows; ++n) {
        LegendSample sample;
        sample.text = whole_number(static_cast<double>(n)).view();
        EXPECT_TRUE(legend.signs.try_push_back(sample));
    }
    return legend;
}

TEST(DataLegend, SignsWithoutAScaleAreLeftOutBeforeAnythingElseIsShortened) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 1024, 768);
    input.legend.highest = 2000;
    const auto planned = [&](const DataLegends& legends, std::uint32_t width, std::uint32_t height = 768) {
        input.data_legends = legends;
        return plan_data_legends(legends, make_layout(width, height, 96, legend_need(input)));
    };
    for (const std::uint32_t width : {640u, 1024u, 1366u}) {
        const DataLegendPlan alone = planned(list_of({wind(), classed_wind(4)}), width);
        const DataLegendPlan with = planned(list_of({wind(), classed_wind(4), signs(10)}), width);
        ASSERT_EQ(alone.cut, 0u);
        EXPECT_GE(with.shown, 2u);
        EXPECT_EQ(with.shown + with.cut, 3u);
        const bool shortens = with.detail >= LegendDetail::scales_alone && alone.detail < LegendDetail::uncertainty_line;
        EXPECT_FALSE(shortens && with.detail > LegendDetail::scales_alone) << width;
    }
    EXPECT_EQ(planned(list_of({wind(), signs(4)}), 1366).cut, 0u) << "with a second column there is room";
    EXPECT_EQ(planned(list_of({wind(), classed_wind(5), land_cover(16), signs(10)}), 640, 480).cut, 1u);
    EXPECT_EQ(planned(list_of({signs(3)}), 1366).cut, 0u);
    EXPECT_GT(data_legend_height(signs(3), LegendDetail::uncertainty_line), 3);
    EXPECT_EQ(data_legend_height(signs(3), LegendDetail::scales_alone), 0);
}

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{320, 240},  {240, 320},   {640, 480},   {480, 640},   {800, 480},   {1024, 768},
                               {768, 1024}, {1080, 1920}, {1920, 1080}, {2560, 1080}, {1080, 2560}, {3840, 2160}};

TEST(DataLegend, NoLegendHidesOtherSymbologyOnAnyScreen) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480);
    input.legend.highest = 2000;
    for (const Screen& screen : kScreens)
        for (const double dpi : {60.0, 96.0, 300.0})
            for (const bool tint : {false, true})
                for (const DataLegends& legends : mixed_lists()) {
                    input.legend.tint = input.legend.bands = tint;
                    input.data_legends = legends;
                    const Layout layout = make_layout(screen.width, screen.height, dpi, legend_need(input));
                    if (!layout.has_legend_rows) continue;
                    const DataLegendPlan plan = plan_data_legends(legends, layout);
                    const std::string what = std::to_string(screen.width) + "x" + std::to_string(screen.height) + " " +
                                             std::to_string(dpi) + " with " + std::to_string(legends.size());
                    EXPECT_EQ(plan.cut, 0u) << what;
                    for (std::size_t i = 0; i < plan.shown; ++i) {
                        const Rect box = plan.boxes[i].shrunk(0.05f);
                        EXPECT_TRUE(layout.screen.contains(box)) << what;
                        for (const LayoutBox& other : kLayoutBoxes)
                            EXPECT_FALSE(box.overlaps(layout.*other.box)) << other.name << " " << what;
                        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(box.overlaps(plan.boxes[j])) << what;
                    }
                }
}

TEST(DataLegend, WhatIsDrawnStaysInItsBoxes) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480);
    input.legend.highest = 2000;
    for (const Screen& screen : kScreens)
        for (const DataLegends& legends : mixed_lists()) {
            input.data_legends = legends;
            const Layout layout = make_layout(screen.width, screen.height, 96, legend_need(input));
            if (!layout.has_legend_rows) continue;
            BatchStore store;
            build_data_legends(Painter(store.batch, layout), legends);
            EXPECT_EQ(store.batch.use().refused, 0u);
            EXPECT_LT(store.batch.use().high_water, kSymbologyVertices / 2);
            const DataLegendPlan plan = plan_data_legends(legends, layout);
            for (const QuadVertex& v : store.batch.vertices()) {
                bool inside = false;
                for (std::size_t n = 0; n < plan.shown; ++n)
                    inside = inside || plan.boxes[n].shrunk(-2.0f).contains(Point{v.x, v.y});
                ASSERT_TRUE(inside) << screen.width << "x" << screen.height << " at " << v.x << ", " << v.y;
            }
        }
}

TEST(DataLegend, TheLastAreLeftOutAndCountedWhereThereIsNoRoom) {
    const DataLegends three = list_of({wind(), classed_wind(3), land_cover(4)});
    const Layout layout = area_of(6);
    const DataLegendPlan plan = plan_data_legends(three, layout);
    EXPECT_EQ(plan.shown, 2u);
    EXPECT_EQ(plan.cut, 1u);
    EXPECT_NE(text_in(three, layout).find("+1WINDM/S51015"), std::string::npos) << text_in(three, layout);
    const Layout none = area_of(1);
    EXPECT_EQ(plan_data_legends(three, none).cut, 3u);
    EXPECT_EQ(text_in(three, none), "");
}

TEST(DataLegend, ThePartIsNamedHoweverShortTheEntryIs) {
    DataLegend member = wind();
    member.part = "MEMBER 3/9";
    const Layout roomy = area_of(20), short_of_room = area_of(3);
    EXPECT_EQ(text_in(list_of({member}), roomy).rfind("WINDM/SMEMBER3/9", 0), 0u) << text_in(list_of({member}), roomy);
    EXPECT_EQ(text_in(list_of({member}), short_of_room).rfind("MEMBER3/9WINDM/S", 0), 0u);
    EXPECT_EQ(text_in(list_of({wind()}), roomy).find("MEMBER"), std::string::npos);
    EXPECT_EQ(data_legend_height(member, LegendDetail::scale), data_legend_height(wind(), LegendDetail::scale));
}

TEST(DataLegend, AllSymbologyWithAllLegendsFitsTheBatch) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 1920, 1080);
    input.legend.highest = 2000;
    input.data_legends = list_of({classed_wind(15), land_cover(16), land_cover(16), classed_wind(15)});
    for (const Screen& screen : kScreens) {
        BatchStore store;
        build_symbology(store.batch, input, make_layout(screen.width, screen.height, 96, legend_need(input)));
        EXPECT_EQ(store.batch.use().refused, 0u);
        EXPECT_LT(store.batch.use().high_water, kSymbologyVertices * 9 / 10);
    }
}

TEST(DataLegend, ADesignWithoutLegendsAndARecoveryPictureHaveNone) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480);
    input.data_legends = list_of({wind()});
    EXPECT_EQ(legend_need(input).data.entries, 1u);
    const auto text = [&] {
        BatchStore store;
        build_symbology(store.batch, input, make_layout(640, 480, 96, legend_need(input)));
        return text_of(store.batch);
    };
    EXPECT_NE(text().find("WINDM/S"), std::string::npos);
    input.shown.legend = false;
    EXPECT_EQ(legend_need(input).data.entries, 0u);
    EXPECT_EQ(text().find("WINDM/S"), std::string::npos);
    input.shown.legend = true;
    input.decisions.unusual_attitude = true;
    EXPECT_EQ(text().find("WINDM/S"), std::string::npos);
    input.decisions.unusual_attitude = false;
    input.legend.ground = false;
    EXPECT_NE(text().find("WINDM/S"), std::string::npos) << "data have a legend of their own";
}

}  // namespace
}  // namespace tedavis::draw::test_data_legend
