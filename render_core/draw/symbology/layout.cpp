#include "render_core/draw/symbology/layout.hpp"

#include <algorithm>

namespace tedavis::draw {
namespace {

constexpr float kTextsAcrossShortSide = 30;  // ordinary size
constexpr float kTextsAcrossWidth = 40;      // below this width in texts the columns would meet
constexpr float kTextsAcrossHeight = 28;
constexpr double kLegibleText_inch = 0.1;  // 2.5 mm an em at arm's length

// In texts.
constexpr float kMargin = 0.4f;
constexpr float kGap = 0.3f;
constexpr float kTopBar = 2.6f;
constexpr float kPhaseWidth = 13.5f;
constexpr float kAirspeedWidth = 5.2f;
constexpr float kLegendWidth = 5.0f;  // what the two columns on the right take more than the one on the left
constexpr float kAltitudeWidth = 6.0f;
constexpr float kVerticalSpeedWidth = 4.2f;
constexpr float kBottomRow = 3.0f;
constexpr float kInformation = 1.2f;
constexpr float kTextsForSecondColumn =
    48.5f;                           // across the screen: the heading keeps 12 texts, the view's middle 6 to either side
constexpr float kLegendRow = 2.65f;  // the shortest legends of data side by side
constexpr float kDeviationWidth = 2.0f;
constexpr float kDeviationHeight = 7.2f;       // below the ends of the scale of bank
constexpr float kAttitudeBelowCenter = 6.02f;  // what the ladder and the scale of bank keep above the rose

// The rose in shares of the screen's height, and of half its own width.
constexpr float kMaxRoseOfHeight = 0.3f;
constexpr float kMaxRoseOfHalfWidth = 1.7f;  // a whole rose with its readout

float text_size(float width, float height, double dpi) {
    const float ordinary = std::min(width, height) / kTextsAcrossShortSide;
    const float legible = static_cast<float>(kLegibleText_inch * dpi);
    return std::min({std::max(ordinary, legible), width / kTextsAcrossWidth, height / kTextsAcrossHeight});
}

/// The foot of the legends' column, as large as what the legends need at least lets it be.
void add_adjacent(Layout& layout, const LegendNeed& need) {
    const float t = layout.text_px, gap = kGap * t;
    const float foot = layout.baro_setting.bottom(), width = layout.legend.width / t;
    const float for_data = need.data.entries > 0 ? need.data.shortest * t + gap : 0;
    const float room = foot - layout.legend.y - need.terrain_least * t - for_data - gap;
    for (std::uint32_t across = maps_across(need.adjacent, width); across <= kMaxMapsAcross; ++across) {
        const float height = adjacent_height(need.adjacent.maps, across, width) * t;
        if (height > room) continue;
        layout.adjacent = {layout.legend.x, foot - height, layout.legend.width, height};
        layout.legend.height = std::min(layout.legend.height, layout.adjacent.y - gap - layout.legend.y);
        return;
    }
}

/// Parts the legend's column between terrain above and data below; what does not fit gets room from the attitude.
void add_data_legends(Layout& layout, const LegendNeed& need) {
    const float t = layout.text_px, gap = kGap * t;
    const float foot = layout.adjacent.empty() ? layout.baro_setting.bottom() : layout.adjacent.y - gap;
    const Rect column{layout.legend.x, layout.legend.y, layout.legend.width, foot - layout.legend.y};
    const float above = need.terrain_most > 0 ? gap : 0, room = column.height - above, whole = need.data.whole * t;
    const bool is_wide = layout.screen.width >= kTextsForSecondColumn * t;
    // With a second column the terrain's legend need not be shortened.
    const float least = (is_wide ? need.terrain_most : need.terrain_least) * t;
    const float terrain = std::min(std::clamp(room - whole, least, need.terrain_most * t), room);
    const float data = std::min(room - terrain, whole);
    layout.legend.height = terrain;
    layout.data_legends[0] = {column.x, column.y + terrain + above, column.width, data};
    if (data >= whole) return;
    if (is_wide) {
        layout.data_legends[1] = {column.right() + gap, column.y, column.width, layout.baro_setting.bottom() - column.y};
        const float right = layout.attitude.right();
        layout.attitude.x = layout.data_legends[1].right() + gap;
        layout.attitude.width = right - layout.attitude.x;
    } else if (data < need.data.shortest * t) {
        layout.data_legends[1] = {layout.attitude.x, layout.attitude.y, layout.attitude.width, kLegendRow * t};
        layout.attitude.y += kLegendRow * t + gap;
        layout.attitude.height -= kLegendRow * t + gap;
    }
}

/// From where the attitude may end to the foot of the columns beside it.
void add_rose(Layout& layout) {
    const float t = layout.text_px, gap = kGap * t, bottom = layout.baro_setting.bottom();
    const Point center = layout.screen.center();
    const float half = std::min(center.x - layout.attitude.x, layout.altitude.x - gap - center.x);
    const float room = bottom - gap - (center.y + kAttitudeBelowCenter * t);
    const float height = std::min({room, kMaxRoseOfHeight * layout.screen.height, kMaxRoseOfHalfWidth * half});
    layout.heading = {center.x - half, bottom - height, 2 * half, height};
    layout.attitude.height = layout.heading.y - gap - layout.attitude.y;
}

}  // namespace

Layout make_layout(std::uint32_t width, std::uint32_t height, double dpi, const LegendNeed& need) noexcept {
    Layout layout;
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const float t = text_size(w, h, dpi);
    const float margin = kMargin * t, gap = kGap * t;
    layout.text_px = t;
    layout.stroke_px = std::max(1.25f, t * 0.1f);
    layout.screen = {0, 0, w, h};

    layout.phase = {margin, margin, kPhaseWidth * t, kTopBar * t};
    layout.notices = {layout.phase.right() + gap, margin, w - margin - layout.phase.right() - gap, kTopBar * t};
    layout.information = {margin, h - margin - kInformation * t, w - 2 * margin, kInformation * t};

    const float bottom_row = layout.information.y - gap - kBottomRow * t;
    const float top = layout.phase.bottom() + gap;
    const float tall = bottom_row - gap - top;
    layout.airspeed = {margin, top, kAirspeedWidth * t, tall};
    layout.vertical_speed = {w - margin - kVerticalSpeedWidth * t, top, kVerticalSpeedWidth * t, tall};
    layout.altitude = {layout.vertical_speed.x - gap - kAltitudeWidth * t, top, kAltitudeWidth * t, tall};
    layout.legend = {layout.airspeed.right() + gap, top, kLegendWidth * t, tall};
    layout.attitude = {layout.legend.right() + gap, top, layout.altitude.x - gap - layout.legend.right() - gap, tall};

    layout.ground_height = {margin, bottom_row, kAirspeedWidth * t, kBottomRow * t};
    layout.baro_setting = {layout.altitude.x, bottom_row, w - margin - layout.altitude.x, kBottomRow * t};
    if (need.adjacent.maps > 0) add_adjacent(layout, need);
    if (need.data.entries > 0) add_data_legends(layout, need);
    add_rose(layout);
    layout.vertical_deviation = {layout.attitude.right() - kDeviationWidth * t, (h - kDeviationHeight * t) / 2,
                                 kDeviationWidth * t, kDeviationHeight * t};
    return layout;
}

Rect conformal_box(const Layout& layout) noexcept {
    const Rect& box = layout.attitude;
    return {box.x, box.y, box.width, layout.heading.bottom() - box.y};
}

}  // namespace tedavis::draw
