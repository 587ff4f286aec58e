/// Layout of the display: boxes in pixels that never overlap and never leave the screen.
///
/// All sizes derive from one unit, the text size, which is proportional to the shorter side of the screen and not below the
/// legible size for the panel's density, as long as the boxes fit. Tested from 320x240 to 4K, portrait too.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/draw/rect.hpp"
#include "render_core/draw/symbology/adjacent_plan.hpp"
#include "render_core/draw/symbology/key_plan.hpp"

namespace tedavis::draw {

/// Room that legends of data need, in text sizes; without entries the layout has no areas for them.
struct DataLegendNeed {
    std::size_t entries = 0;
    float whole = 0;     ///< all of them, with everything
    float shortest = 0;  ///< all of them, with the scales alone
};
/// Room of all legends, including the terrain's, whose bar of values may shrink.
struct LegendNeed {
    float terrain_most = 0, terrain_least = 0;  ///< 0: there is none
    DataLegendNeed data;
    AdjacentNeed adjacent;
    bool keeps_column = false;    ///< the column stays while nothing stands in it, so that the attitude does not move
    std::size_t key_entries = 0;  ///< of the key, which stands where there are no legends, or no room for their rows

    [[nodiscard]] bool has_legends() const { return keeps_column || terrain_most > 0 || data.entries > 0; }
    [[nodiscard]] bool has_column() const { return has_legends() || adjacent.maps > 0; }
};

inline constexpr std::size_t kDataLegendAreas = 2;
/// Texts smaller than this have rows of legends that are lower than the smallest text: the key stands in their place.
inline constexpr float kMinLegendText_px = 10.5f;

struct Layout {
    float text_px = 0;    ///< pixels an em of ordinary text
    float stroke_px = 0;  ///< width of ordinary lines
    Rect screen;
    Rect annunciations;            ///< strip along the whole top: flight phase, warnings and cautions (annunciations.hpp)
    Rect airspeed;                 ///< left tape
    bool has_legend_rows = false;  ///< legends are requested, and their rows do not touch each other
    Rect legend;                   ///< of the terrain; right of the airspeed, at least 5 texts wide. Empty without legends
    Rect attitude;                 ///< around the middle of the screen, above the rose; ladder, roll scale
    Rect altitude;                 ///< right tape
    Rect vertical_speed;           ///< right of it
    Rect ground_height;            ///< bottom left; on small screens wider than the tape above it
    /// Compass rose with its readout: bottom, centred on the screen, between the columns, or below them on a narrow screen with
    /// small text. compass_rose.hpp divides it.
    Rect heading;
    Rect baro_setting;           ///< bottom right
    Rect vertical_speed_number;  ///< bottom right, where the column of vertical speeds is too narrow for its number; else empty
    Rect vertical_deviation;     ///< at the right edge of the attitude and within it, at the height of the screen's middle
    Rect information;            ///< last line: where the flight and the data come from
    /// Legends of data: the foot of the column of the legend, down to the last row; then, where these are too many for it, a
    /// column beside it, or on screens that are too narrow a row below the attitude. Empty where there is no need.
    std::array<Rect, kDataLegendAreas> data_legends{};
    /// Wind and temperature: the upper right corner of the attitude, or of the row of the key where that leaves room.
    Rect air;
    /// The key of the scales that are shown: beside the rose at the foot of the airspeed, or a row above the attitude where the
    /// rose leaves no room for it. Its box is empty where there is no need.
    KeyPlan key;
    /// Maps beside the picture: below all legends in their column. Empty where there is no need, or no room beside the shortest
    /// legends and the least of the terrain's.
    Rect adjacent;
};
static_assert(std::is_trivially_copyable_v<Layout>);

inline constexpr float kDeviationName = 1.2f;  ///< the row above the scale of the vertical deviation, in texts

inline constexpr std::size_t kLayoutBoxCount = 10;
struct LayoutBox {
    const char* name;
    Rect Layout::*box;
};
/// All boxes that share the screen.
inline constexpr LayoutBox kLayoutBoxes[kLayoutBoxCount] = {
    {"annunciations", &Layout::annunciations}, {"airspeed", &Layout::airspeed}, {"legend", &Layout::legend},
    {"attitude", &Layout::attitude},           {"altitude", &Layout::altitude}, {"vertical_speed", &Layout::vertical_speed},
    {"ground_height", &Layout::ground_height}, {"heading", &Layout::heading},   {"baro_setting", &Layout::baro_setting},
    {"information", &Layout::information},
};

/// Returns the area for conformal symbols between the columns: the attitude's box and the rose below it, which has no background
/// and is drawn over them.
[[nodiscard]] Rect conformal_box(const Layout& layout) noexcept;

/// `width`, `height` in pixels, at least 320 x 240 either way round; `dpi` pixels an inch.
[[nodiscard]] Layout make_layout(std::uint32_t width, std::uint32_t height, double dpi, const LegendNeed& asked = {}) noexcept;

}  // namespace tedavis::draw
