/// Entries of the legend for tests: wind in m/s, continuous or in classes, and land cover by name.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "render_core/draw/symbology/data_legend.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::test_support {

inline constexpr std::int64_t kMinute_ns = 60'000'000'000;

inline draw::LegendSample sample(const char* text, draw::SampleLook look) {
    draw::LegendSample made;
    made.text = text;
    made.color = {210, 140, 60};
    made.under = {60, 70, 90};
    made.look = look;
    made.share = 0.8;
    return made;
}

/// Wind from 0 to 20 m/s, with everything that an entry can have.
inline draw::DataLegend wind() {
    draw::DataLegend legend;
    legend.title = "WIND";
    legend.unit = "M/S";
    legend.scale.palette.title = "WIND";
    EXPECT_TRUE(legend.scale.palette.stops.try_push_back({0, {250, 240, 220}}));
    EXPECT_TRUE(legend.scale.palette.stops.try_push_back({20, {30, 20, 120}}));
    EXPECT_TRUE(legend.uncertainty.try_push_back(sample("CERTAIN", draw::SampleLook::plain)));
    EXPECT_TRUE(
        legend.uncertainty.try_push_back(sample("\xC2\xB1"
                                                "4 M/S",
                                                draw::SampleLook::grains)));
    EXPECT_TRUE(legend.uncertainty.try_push_back(sample("UNKNOWN", draw::SampleLook::cut_stripes)));
    EXPECT_TRUE(legend.signs.try_push_back(sample("MISSING", draw::SampleLook::dots)));
    EXPECT_TRUE(legend.signs.try_push_back(sample("INTERPOLATED", draw::SampleLook::cut_grid)));
    legend.has_time = legend.has_age = true;
    legend.data_time_ns = 13 * 60 * kMinute_ns + 5 * kMinute_ns;
    legend.age = {12 * kMinute_ns};
    legend.source = "WIND.TIF";
    return legend;
}
inline draw::DataLegend classed_wind(std::size_t limits) {
    draw::DataLegend legend = wind();
    for (std::size_t n = 0; n < limits; ++n)
        EXPECT_TRUE(legend.scale.breaks.try_push_back(20.0 * static_cast<double>(n + 1) / static_cast<double>(limits + 1)));
    return legend;
}
inline draw::DataLegend land_cover(std::size_t classes) {
    draw::DataLegend legend = wind();
    legend.title = "LAND COVER";
    legend.unit = "";
    for (std::size_t n = 0; n < classes; ++n) EXPECT_TRUE(legend.class_names.try_push_back("WOODLAND WITH CLEARINGS"));
    return legend;
}

inline draw::DataLegends list_of(std::initializer_list<draw::DataLegend> entries) {
    draw::DataLegends legends;
    for (const draw::DataLegend& entry : entries) EXPECT_TRUE(legends.try_push_back(entry));
    return legends;
}

/// A layout with one area of so many texts.
inline draw::Layout area_of(float height) {
    draw::Layout layout = draw::make_layout(1280, 960, 96);
    layout.data_legends = {};
    layout.data_legends[0] = {100, 20, 5 * layout.text_px, height * layout.text_px};
    return layout;
}
inline std::string text_in(const draw::DataLegends& legends, const draw::Layout& layout) {
    BatchStore store;
    draw::build_data_legends(draw::Painter(store.batch, layout), legends);
    return text_of(store.batch);
}
inline std::string text_at(const draw::DataLegend& legend, draw::LegendDetail detail) {
    const draw::DataLegends legends = list_of({legend});
    const draw::Layout layout = area_of(draw::data_legend_height(legend, detail));
    EXPECT_EQ(draw::plan_data_legends(legends, layout).detail, detail);
    return text_in(legends, layout);
}

}  // namespace tedavis::test_support
