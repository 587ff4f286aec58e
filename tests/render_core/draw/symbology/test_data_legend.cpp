#include "render_core/draw/symbology/data_legend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/batch_rasterizer.hpp"
#include "tests/support/symbology_scene.hpp"

namespace tedavis::draw {
namespace {

using design::Color;
using test_support::BatchStore;
using test_support::Picture;
using test_support::text_of;

constexpr std::int64_t kMinute_ns = 60'000'000'000;

LegendSample sample(const char* text, SampleLook look) {
    LegendSample made;
    made.text = text;
    made.color = {210, 140, 60};
    made.under = {60, 70, 90};
    made.look = look;
    made.share = 0.8;
    return made;
}

/// Wind from 0 to 20 m/s, with everything that an entry can have.
DataLegend wind() {
    DataLegend legend;
    legend.title = "WIND";
    legend.unit = "M/S";
    legend.scale.palette.title = "WIND";
    EXPECT_TRUE(legend.scale.palette.stops.try_push_back({0, {250, 240, 220}}));
    EXPECT_TRUE(legend.scale.palette.stops.try_push_back({20, {30, 20, 120}}));
    EXPECT_TRUE(legend.uncertainty.try_push_back(sample("SURE", SampleLook::plain)));
    EXPECT_TRUE(
        legend.uncertainty.try_push_back(sample("\xC2\xB1"
                                                "4 M/S",
                                                SampleLook::grains)));
    EXPECT_TRUE(legend.uncertainty.try_push_back(sample("UNKNOWN", SampleLook::cut_stripes)));
    EXPECT_TRUE(legend.signs.try_push_back(sample("MISSING", SampleLook::dots)));
    EXPECT_TRUE(legend.signs.try_push_back(sample("FILLED IN", SampleLook::cut_grid)));
    legend.has_time = legend.has_age = true;
    legend.data_time_ns = 13 * 60 * kMinute_ns + 5 * kMinute_ns;
    legend.age = {12 * kMinute_ns};
    legend.source = "WIND.TIF";
    return legend;
}
DataLegend classed_wind(std::size_t limits) {
    DataLegend legend = wind();
    for (std::size_t n = 0; n < limits; ++n)
        EXPECT_TRUE(legend.scale.breaks.try_push_back(20.0 * static_cast<double>(n + 1) / static_cast<double>(limits + 1)));
    return legend;
}
DataLegend land_cover(std::size_t classes) {
    DataLegend legend = wind();
    legend.title = "LAND COVER";
    legend.unit = "";
    for (std::size_t n = 0; n < classes; ++n) EXPECT_TRUE(legend.class_names.try_push_back("WOODLAND WITH CLEARINGS"));
    return legend;
}

DataLegends list_of(std::initializer_list<DataLegend> entries) {
    DataLegends legends;
    for (const DataLegend& entry : entries) EXPECT_TRUE(legends.try_push_back(entry));
    return legends;
}

/// A layout with one area of so many texts.
Layout area_of(float height) {
    Layout layout = make_layout(640, 480, 96);
    layout.data_legends = {};
    layout.data_legends[0] = {100, 20, 5 * layout.text_px, height * layout.text_px};
    return layout;
}
std::string text_in(const DataLegends& legends, const Layout& layout) {
    BatchStore store;
    build_data_legends(Painter(store.batch, layout), legends);
    return text_of(store.batch);
}
std::string text_at(const DataLegend& legend, LegendDetail detail) {
    const DataLegends legends = list_of({legend});
    const Layout layout = area_of(data_legend_height(legend, detail));
    EXPECT_EQ(plan_data_legends(legends, layout).detail, detail);
    return text_in(legends, layout);
}

TEST(DataLegend, SaysLessTheLessRoomThereIsAndNeverLosesTheScale) {
    EXPECT_EQ(text_at(wind(), LegendDetail::whole),
              "WINDM/S05101520SURE\xB1"
              "4M/SUNKNOWNMISSINGFILLEDIN13:05Z12MINWIND.TIF");
    EXPECT_EQ(text_at(wind(), LegendDetail::flat),
              "WINDM/S01020SURE\xB1"
              "4M/SUNKNOWNMISSINGFILLEDIN13:05Z12MINWIND.TIF");
    EXPECT_EQ(text_at(wind(), LegendDetail::without_source),
              "WINDM/S01020SURE\xB1"
              "4M/SUNKNOWNMISSINGFILLEDIN13:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::without_signs),
              "WINDM/S01020SURE\xB1"
              "4M/SUNKNOWN13:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::uncertainty_line),
              "WINDM/S010200\xB1"
              "4?13:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::scale_and_time), "WINDM/S0102013:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::scale), "WINDM/S01020");
}

TEST(DataLegend, ClassesHaveTheirLimits) {
    EXPECT_EQ(text_at(classed_wind(3), LegendDetail::whole).substr(0, 14), "WINDM/S51015SU");
    EXPECT_EQ(text_at(classed_wind(3), LegendDetail::scale), "WINDM/S51015");
    DataLegend fine = classed_wind(0);
    for (const double limit : {0.25, 0.5, 12.0}) EXPECT_TRUE(fine.scale.breaks.try_push_back(limit));
    EXPECT_EQ(text_at(fine, LegendDetail::whole).substr(0, 16), "WINDM/S0.250.512");
    DataLegend degrees = classed_wind(0);
    degrees.factor = 180 / 3.14159265358979323846;
    EXPECT_TRUE(degrees.scale.breaks.try_push_back(0.52359877559829887));
    EXPECT_EQ(text_at(degrees, LegendDetail::scale), "WINDM/S30");
}

TEST(DataLegend, NominalValuesHaveNamesAndWhatIsNotNamedIsCounted) {
    DataLegend cover = land_cover(0);
    for (const char* name : {"WATER", "WOOD", "ROCK", "ICE", "TOWN"}) EXPECT_TRUE(cover.class_names.try_push_back(name));
    EXPECT_EQ(text_at(cover, LegendDetail::whole).substr(0, 31), "LANDCOVERWATERWOODROCKICETOWNSU");
    EXPECT_EQ(text_at(cover, LegendDetail::scale_and_time), "LANDCOVERWATERWOODROCK+2MORE13:05Z12MIN");
    EXPECT_EQ(text_at(cover, LegendDetail::scale), "LANDCOVER5KINDS");
}

TEST(DataLegend, TimeAndAgeSayHowOldDataAreOrHowFarAhead) {
    DataLegend legend = wind();
    const auto text = [&](std::int64_t age_ns) {
        legend.age = {age_ns};
        return std::string(time_and_age(legend).view());
    };
    EXPECT_EQ(text(0), "13:05Z 0 MIN");
    EXPECT_EQ(text(12 * kMinute_ns + 59), "13:05Z 12 MIN");
    EXPECT_EQ(text(-40 * kMinute_ns), "13:05Z IN 40 MIN");
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

TEST(DataLegend, WhatIsStaleIsAmberAtEveryDetail) {
    const auto amber = [](const DataLegend& legend, LegendDetail detail) {
        const Layout layout = area_of(data_legend_height(legend, detail));
        BatchStore store;
        build_data_legends(Painter(store.batch, layout), list_of({legend}));
        int count = 0;
        for (const QuadVertex& v : store.batch.vertices())
            count +=
                v.rgba[0] == kCautionColor.red && v.rgba[1] == kCautionColor.green && v.rgba[2] == kCautionColor.blue ? 1 : 0;
        return count;
    };
    DataLegend stale = wind();
    stale.is_stale = true;
    for (std::size_t n = 0; n < kLegendDetails; ++n) {
        EXPECT_GT(amber(stale, static_cast<LegendDetail>(n)), 0) << n;
        EXPECT_EQ(amber(wind(), static_cast<LegendDetail>(n)), 0) << n;
    }
}

/// In the raster of a legend at `detail`, the colour on the scale at a share of its length.
Color color_on_scale(const DataLegend& legend, LegendDetail detail, double share) {
    const Layout layout = area_of(data_legend_height(legend, detail));
    BatchStore store;
    build_data_legends(Painter(store.batch, layout), list_of({legend}));
    Picture picture(640, 480, {0, 0, 0});
    rasterize(store.batch, picture);
    const float t = layout.text_px;
    if (detail == LegendDetail::whole) {
        const double classes = static_cast<double>(legend.scale.breaks.size() + 1);
        const double height = static_cast<double>(t) * (classes < 2 ? 5 : std::min(classes, 8.0));
        const double top = 20 + static_cast<double>(t) * (1 + 0.45);
        return picture.at(static_cast<int>(100 + 0.6f * t), static_cast<int>(top + height * (1 - share)));
    }
    return picture.at(static_cast<int>(100 + 0.3f * t + 4.4f * t * static_cast<float>(share)), static_cast<int>(20 + 1.25f * t));
}

TEST(DataLegend, TheScaleHasTheColoursOfItsValues) {
    for (const LegendDetail detail : {LegendDetail::whole, LegendDetail::flat, LegendDetail::scale}) {
        const DataLegend smooth = wind();
        for (const double share : {0.1, 0.3, 0.62, 0.9}) {
            const Color found = color_on_scale(smooth, detail, share), wanted = color_of_value(smooth.scale.palette, 20 * share);
            EXPECT_LE(std::abs(found.red - wanted.red), 8) << share;
            EXPECT_LE(std::abs(found.blue - wanted.blue), 8) << share;
        }
        const DataLegend classed = classed_wind(4);
        for (std::size_t n = 0; n < 5; ++n)
            EXPECT_EQ(color_on_scale(classed, detail, (static_cast<double>(n) + 0.5) / 5), color_of_class(classed.scale, n))
                << n << " at detail " << static_cast<int>(detail);
    }
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
}  // namespace tedavis::draw
