#include "render_core/draw/text_size.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/draw/drawn_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_text_size {
namespace {

using flight::LegendShow;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::DrawnGlyph;

struct TextScreen {
    std::uint32_t width, height;
    double dpi;
};
constexpr TextScreen kTextScreens[] = {{240, 320, 96}, {320, 240, 96},  {480, 272, 96},  {480, 800, 96},
                                       {640, 480, 96}, {1280, 720, 96}, {1024, 768, 300}};
constexpr ElementShow kShows[] = {ElementShow::normal, ElementShow::substituted, ElementShow::flagged, ElementShow::failed};

/// All that guides, with values that have as many digits as they may have; every element shown as `show`.
SymbologyInput full_input(const TextScreen& screen, ElementShow show, LegendShow legend) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), screen.width, screen.height);
    for (std::size_t n = 0; n < policy::kElementCount; ++n) input.decisions[static_cast<policy::Element>(n)].show = show;
    input.guidance.selected_altitude_m = 12'500 * base::kMetresPerFoot;
    input.guidance.selected_airspeed_mps = 128 * base::kMpsPerKnot;
    input.guidance.selected_vertical_speed_mps = -3540 * base::kMpsPerFootPerMinute;
    input.guidance.baro_minimum_m = 1343 * base::kMetresPerFoot;
    input.guidance.radio_minimum_m = 200 * base::kMetresPerFoot;
    input.guidance.navigation_source = flight::NavigationSource::gnss;
    input.ground_height_m = 986 * base::kMetresPerFoot;
    input.altitude_m = 12'340 * base::kMetresPerFoot;
    input.vertical_speed_mps = -3540 * base::kMpsPerFootPerMinute;
    input.wind_speed_mps = 12 * base::kMpsPerKnot;
    input.wind_from_rad = base::radians(241);
    input.outside_temperature_k = 273;
    input.legend_show = legend;
    input.legend.highest = 2000;
    input.data_legends = test_support::list_of({test_support::wind(), test_support::classed_wind(4)});
    return input;
}

struct Drawn {
    Layout layout;
    std::vector<DrawnGlyph> glyphs;
};

Drawn drawn(const TextScreen& screen, ElementShow show, LegendShow legend) {
    const SymbologyInput input = full_input(screen, show, legend);
    Drawn made{make_layout(screen.width, screen.height, screen.dpi, legend_need(input)), {}};
    BatchStore store;
    build_symbology(store.batch, input, made.layout);
    EXPECT_EQ(store.batch.use().refused, 0u);
    made.glyphs = test_support::drawn_shapes_of(store.batch).glyphs;
    return made;
}

/// What the ink of an upright character takes; little of a dot, also of the one between two notices.
Rect ink_of(const DrawnGlyph& glyph) {
    const bool is_dot = glyph.character == '.' || static_cast<unsigned char>(glyph.character) == 0xB7u;
    if (is_dot) return Rect{glyph.at.x, glyph.at.y, 0, 0}.shrunk(-0.07f * glyph.em_px);
    const float width = 0.8f * text_width_px(std::string_view(&glyph.character, 1), glyph.em_px),
                height = 0.9f * font_atlas().cap_height_em * glyph.em_px;
    return {glyph.at.x - width / 2, glyph.at.y - height / 2, width, height};
}

/// Boxes in which all texts are upright.
std::vector<std::pair<std::string, Rect>> upright_boxes(const Layout& layout) {
    std::vector<std::pair<std::string, Rect>> boxes;
    for (const LayoutBox& entry : kLayoutBoxes)
        if (entry.box != &Layout::attitude && entry.box != &Layout::heading) boxes.emplace_back(entry.name, layout.*entry.box);
    for (const Rect& area : layout.data_legends) boxes.emplace_back("data legends", area);
    for (std::size_t n = 0; n < layout.key.shown; ++n) boxes.emplace_back("key", layout.key.cell_at(n));
    return boxes;
}

std::string words_for(const TextScreen& screen, ElementShow show, LegendShow legend) {
    return std::to_string(screen.width) + "x" + std::to_string(screen.height) + ", shown " +
           std::to_string(static_cast<int>(show)) + ", legend " + std::string(name_of(legend));
}

template <class Check>
void for_all(const Check& check) {
    for (const TextScreen& screen : kTextScreens)
        for (const ElementShow show : kShows)
            for (const LegendShow legend : {LegendShow::none, LegendShow::key, LegendShow::whole})
                check(drawn(screen, show, legend), words_for(screen, show, legend));
}

float smallest_px(const std::vector<DrawnGlyph>& glyphs) {
    float smallest = 999;
    for (const DrawnGlyph& glyph : glyphs) smallest = std::min(smallest, glyph.em_px);
    return smallest;
}

TEST(TextSize, NoTextIsSmallerThan11PixelsOnAnyScreen) {
    for_all([](const Drawn& made, const std::string& what) {
        ASSERT_GT(made.glyphs.size(), 20u) << what;
        EXPECT_GE(smallest_px(made.glyphs), kMinText_px - 0.01f) << what;
    });
    // The control: a text that is put into the batch without the painter is found.
    BatchStore store;
    store.batch.text("IAS KT", {50, 50}, TextAnchor::center, {7.4f, design::Color{255, 255, 255}});
    EXPECT_LT(smallest_px(test_support::drawn_shapes_of(store.batch).glyphs), kMinText_px - 0.01f);
}

TEST(TextSize, NoTextLeavesItsBox) {
    for_all([](const Drawn& made, const std::string& what) {
        const auto boxes = upright_boxes(made.layout);
        for (const DrawnGlyph& glyph : made.glyphs) {
            EXPECT_TRUE(made.layout.screen.contains(ink_of(glyph))) << what << ": " << glyph.character;
            for (const auto& [name, box] : boxes)
                if (box.contains(glyph.at)) {
                    EXPECT_TRUE(box.shrunk(-0.75f).contains(ink_of(glyph)))
                        << what << ": " << glyph.character << " at " << glyph.at.x << ", " << glyph.at.y << " in " << name;
                }
        }
    });
}

/// Digits that roll in a window are cut there; the tapes of speed and altitude have tests of their own.
TEST(TextSize, NoTextCoversAnother) {
    for_all([](const Drawn& made, const std::string& what) {
        for (const auto& [name, box] : upright_boxes(made.layout)) {
            if (name == "airspeed" || name == "altitude") continue;
            std::vector<DrawnGlyph> inside;
            for (const DrawnGlyph& glyph : made.glyphs)
                if (box.contains(glyph.at)) inside.push_back(glyph);
            for (std::size_t n = 0; n < inside.size(); ++n)
                for (std::size_t k = 0; k < n; ++k)
                    EXPECT_FALSE(ink_of(inside[n]).shrunk(0.3f).overlaps(ink_of(inside[k]).shrunk(0.3f)))
                        << what << ": " << inside[k].character << " and " << inside[n].character << " in " << name << " at "
                        << inside[n].at.x << ", " << inside[n].at.y;
        }
    });
}

}  // namespace
}  // namespace tedavis::draw::test_text_size
