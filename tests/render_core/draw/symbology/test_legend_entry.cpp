#include "render_core/draw/symbology/legend_entry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/data_legend_samples.hpp"

namespace tedavis::draw::test_legend_entry {
namespace {

using design::Color;
using test_support::area_of;
using test_support::BatchStore;
using test_support::classed_wind;
using test_support::land_cover;
using test_support::list_of;
using test_support::Picture;
using test_support::text_at;
using test_support::wind;

TEST(LegendEntry, SaysLessTheLessRoomThereIsAndNeverLosesTheScale) {
    EXPECT_EQ(text_at(wind(), LegendDetail::whole),
              "WINDM/S05101520CERTAIN\xB1"
              "4M/SUNKNOWNMISSINGINTERPOLATED13:05Z12MINWIND.TIF");
    EXPECT_EQ(text_at(wind(), LegendDetail::flat),
              "WINDM/S01020CERTAIN\xB1"
              "4M/SUNKNOWNMISSINGINTERPOLATED13:05Z12MINWIND.TIF");
    EXPECT_EQ(text_at(wind(), LegendDetail::without_source),
              "WINDM/S01020CERTAIN\xB1"
              "4M/SUNKNOWNMISSINGINTERPOLATED13:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::without_signs),
              "WINDM/S01020CERTAIN\xB1"
              "4M/SUNKNOWN13:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::uncertainty_line),
              "WINDM/S010200\xB1"
              "4?13:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::scale_and_time), "WINDM/S0102013:05Z12MIN");
    EXPECT_EQ(text_at(wind(), LegendDetail::scale), "WINDM/S01020");
}

TEST(LegendEntry, TheUnknownIsAQuestionMarkOnALineHoweverItLooks) {
    DataLegend faded = wind();
    for (LegendSample& sample : faded.uncertainty) sample.look = SampleLook::plain;
    EXPECT_EQ(text_at(faded, LegendDetail::uncertainty_line), text_at(wind(), LegendDetail::uncertainty_line));
}

TEST(LegendEntry, ClassesHaveTheirLimits) {
    EXPECT_EQ(text_at(classed_wind(3), LegendDetail::whole).substr(0, 14), "WINDM/S51015CE");
    EXPECT_EQ(text_at(classed_wind(3), LegendDetail::scale), "WINDM/S51015");
    DataLegend fine = classed_wind(0);
    for (const double limit : {0.25, 0.5, 12.0}) EXPECT_TRUE(fine.scale.breaks.try_push_back(limit));
    EXPECT_EQ(text_at(fine, LegendDetail::whole).substr(0, 16), "WINDM/S0.250.512");
    DataLegend degrees = classed_wind(0);
    degrees.factor = 180 / 3.14159265358979323846;
    EXPECT_TRUE(degrees.scale.breaks.try_push_back(0.52359877559829887));
    EXPECT_EQ(text_at(degrees, LegendDetail::scale), "WINDM/S30");
}

TEST(LegendEntry, NominalValuesHaveNamesAndWhatIsNotNamedIsCounted) {
    DataLegend cover = land_cover(0);
    for (const char* name : {"WATER", "WOOD", "ROCK", "ICE", "TOWN"}) EXPECT_TRUE(cover.class_names.try_push_back(name));
    EXPECT_EQ(text_at(cover, LegendDetail::whole).substr(0, 31), "LANDCOVERWATERWOODROCKICETOWNCE");
    EXPECT_EQ(text_at(cover, LegendDetail::scale_and_time), "LANDCOVERWATERWOODROCK+2MORE13:05Z12MIN");
    EXPECT_EQ(text_at(cover, LegendDetail::scale), "LANDCOVER5CLASSES");
}

TEST(LegendEntry, WhatIsStaleIsAmberAtEveryDetail) {
    const auto amber = [](const DataLegend& legend, LegendDetail detail) {
        const Layout layout = area_of(data_legend_height(legend, detail));
        BatchStore store;
        build_data_legends(Painter(store.batch, layout), list_of({legend}));
        int count = 0;
        for (const QuadVertex& v : store.batch.vertices())
            count += v.rgba[0] == test_support::day_color(SymbolRole::caution).red &&
                             v.rgba[1] == test_support::day_color(SymbolRole::caution).green &&
                             v.rgba[2] == test_support::day_color(SymbolRole::caution).blue
                         ? 1
                         : 0;
        return count;
    };
    DataLegend stale = wind();
    stale.is_stale = true;
    EXPECT_NE(text_at(stale, LegendDetail::without_signs).find("13:05ZSTALE12MIN"), std::string::npos);
    EXPECT_NE(text_at(stale, LegendDetail::scale_and_time).find("1020STALE12MIN"), std::string::npos) << "the age is what counts";
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

TEST(LegendEntry, TheScaleHasTheColorsOfItsValues) {
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

}  // namespace
}  // namespace tedavis::draw::test_legend_entry
