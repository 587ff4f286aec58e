#include "render_core/draw/symbology/layout.hpp"

#include <algorithm>

#include "render_core/draw/text_size.hpp"

namespace tedavis::draw {
namespace {

constexpr float kTextsAcrossShortSide = 30;  // ordinary size
constexpr float kTextsAcrossWidth = 40;      // below this width in texts the columns would meet
constexpr float kTextsAcrossHeight = 28;
constexpr double kLegibleText_inch = 0.1;  // 2.5 mm an em at arm's length

// In texts.
constexpr float kMargin = 0.4f;
constexpr float kGap = 0.3f;
constexpr float kStrip = 1.9f, kStripOfTwoRows = 2.9f;
constexpr float kTextsForOneRow = 48;  // across the screen: the phase, and three notices beside it
constexpr float kAirspeedWidth = 5.2f;
constexpr float kLegendWidth = 5.0f;  // at least: what the two columns on the right take more than the one on the left
constexpr float kAltitudeWidth = 6.0f;
constexpr float kVerticalSpeedWidth = 4.2f;
constexpr float kBottomRow = 3.0f;
constexpr float kInformation = 1.2f;
constexpr float kTextsForSecondColumn =
    48.5f;                             // across the screen: the heading keeps 12 texts, the view's middle 6 to either side
constexpr float kMinHalfView = 6.05f;  // of the view's middle, to either side
constexpr float kLegendRow = 2.65f;    // the shortest legends of data side by side
constexpr float kDeviationWidth = 2.0f;
constexpr float kDeviationHeight = 7.2f;       // below the ends of the scale of bank
constexpr float kAttitudeBelowCenter = 6.02f;  // what the ladder and the scale of bank keep above the rose

// In ems of the smallest text: what a height above ground with its label takes, and wind and temperature.
constexpr float kGroundHeightEms = 5.6f, kAirEms = 5.4f, kMinAirEms = 5.25f, kLegendEms = 9.2f;
// The same of an altitude of five digits without the pointer of its readout, of a vertical speed with its sign, of an altimeter
// setting with its label, and of a row of the strip, in which notices have frames.
constexpr float kAltitudeEms = 3.5f, kPointer = 1.02f, kVerticalSpeedEms = 3.28f, kBaroEms = 5.8f, kStripRowEms = 1.3f;
constexpr float kStripEdges = 0.2f;
constexpr float kAirWidth = 4.6f, kAirRow = 1.3f, kAirInset = 0.1f;
constexpr float kMaxKeyRowsOfHeight = 0.08f;  // of the screen's height, for more than one row

// The rose in shares of the screen's height, and of half its own width.
constexpr float kMaxRoseOfHeight = 0.3f;
constexpr float kMaxRoseOfHalfWidth = 1.7f;  // a whole rose with its readout
// What the card takes of its box to either side of its middle, and what stands beside it in texts.
constexpr float kRoseHalfOfHeight = 0.76f, kRoseTexts = 4.3f;

float text_size(float width, float height, double dpi) {
    const float ordinary = std::min(width, height) / kTextsAcrossShortSide;
    const float legible = static_cast<float>(kLegibleText_inch * dpi);
    return std::min({std::max(ordinary, legible), width / kTextsAcrossWidth, height / kTextsAcrossHeight});
}

/// As wide as the smallest text asks for, if the view keeps its middle beside the columns.
float legend_width(const Layout& layout, float from) {
    const float t = layout.text_px, gap = kGap * t;
    const float room = layout.screen.center().x - kMinHalfView * t - from;
    const float most = layout.screen.width >= kTextsForSecondColumn * t ? room / 2 - gap : room - gap;
    return std::max(kLegendWidth * t, std::min(kLegendEms * kMinText_px, most));
}

/// Where the columns beside the attitude end: on small screens above the height above ground, which is wider than the tape.
float columns_foot(const Layout& layout) {
    const bool is_above = layout.ground_height.right() > layout.legend.x;
    return is_above ? layout.airspeed.bottom() : layout.baro_setting.bottom();
}

/// The foot of the legends' column, as large as what the legends need at least lets it be.
void add_adjacent(Layout& layout, const LegendNeed& need) {
    const float t = layout.text_px, gap = kGap * t;
    const float foot = columns_foot(layout), width = layout.legend.width / t;
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
    const float foot = layout.adjacent.empty() ? columns_foot(layout) : layout.adjacent.y - gap;
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

/// The rose has no room for texts between the columns of a narrow screen: it is below them there, across the whole screen.
bool has_rose_below_columns(float width, float height, float text_px) { return text_px < kMinText_px && height > 1.2f * width; }

/// Below the columns of a narrow screen, which end above it.
void add_rose_below(Layout& layout, float bottom) {
    const float t = layout.text_px, margin = kMargin * t, gap = kGap * t;
    const float top = layout.screen.center().y + kAttitudeBelowCenter * t + gap;
    const float height = std::min(bottom - top, kMaxRoseOfHeight * layout.screen.height);
    layout.heading = {margin, bottom - height, layout.screen.width - 2 * margin, height};
    for (Rect* column : {&layout.airspeed, &layout.legend, &layout.attitude, &layout.altitude, &layout.vertical_speed})
        if (!column->empty()) column->height = layout.heading.y - gap - column->y;
}

/// From where the attitude may end to the foot of the columns beside it.
void add_rose(Layout& layout) {
    const float t = layout.text_px, gap = kGap * t, bottom = layout.baro_setting.bottom();
    const Point center = layout.screen.center();
    const float left = std::max(layout.attitude.x, layout.ground_height.right() + gap);
    const float half = std::min(center.x - left, layout.altitude.x - gap - center.x);
    const float room = bottom - gap - (center.y + kAttitudeBelowCenter * t);
    const float height = std::min({room, kMaxRoseOfHeight * layout.screen.height, kMaxRoseOfHalfWidth * half});
    layout.heading = {center.x - half, bottom - height, 2 * half, height};
    layout.attitude.height = layout.heading.y - gap - layout.attitude.y;
}

/// Beside the rose, which keeps the width of its card and texts; else above the attitude, which becomes smaller.
void add_key(Layout& layout, std::size_t entries) {
    const float t = layout.text_px, gap = kGap * t, center = layout.screen.center().x;
    const float picture_px2 = layout.screen.width * layout.screen.height;
    const float half = std::min(layout.heading.width / 2, kRoseHalfOfHeight * layout.heading.height + kRoseTexts * t);
    const float left = std::max(layout.attitude.x, layout.ground_height.right() + gap);
    const Rect beside{left, layout.heading.y, center - half - gap - left, layout.heading.height};
    layout.key = plan_key(beside, KeyOrder::column, entries, picture_px2, t);
    if (layout.key.shown > 0) {
        layout.heading = {center - half, layout.heading.y, 2 * half, layout.heading.height};
        return;
    }
    const float rows = std::max(key_cell(t).height_px, kMaxKeyRowsOfHeight * layout.screen.height);
    layout.key =
        plan_key({layout.attitude.x, layout.attitude.y, layout.attitude.width, rows}, KeyOrder::rows, entries, picture_px2, t);
    if (layout.key.shown == 0) return;
    const float taken = layout.key.box.height + gap;
    layout.attitude.y += taken;
    layout.attitude.height -= taken;
}

void add_air(Layout& layout) {
    const float t = layout.text_px, inset = kAirInset * t, row = legible_row_px(kAirRow, t),
                right = layout.attitude.right() - inset;
    // An arrow stands before the wind.
    const float least = std::max(kAirWidth * t, row + kMinAirEms * kMinText_px),
                width = std::max(least, row + kAirEms * kMinText_px);
    const Rect& key = layout.key.box;
    const float beside_key = right - key.right();
    const bool has_room_above = !key.empty() && key.bottom() <= layout.attitude.y && beside_key >= least;
    if (has_room_above)
        layout.air = {right - std::min(width, beside_key), key.y, std::min(width, beside_key), 2 * row};
    else
        layout.air = {right - width, layout.attitude.y + inset, width, 2 * row};
}

/// Legends or the key, not both.
LegendNeed fitting_need(const LegendNeed& asked, float text_px) {
    LegendNeed need = asked;
    if (!asked.has_legends()) return need;
    if (text_px >= kMinLegendText_px) {
        need.key_entries = 0;
        return need;
    }
    need.terrain_most = need.terrain_least = 0;
    need.data = {};
    need.keeps_column = false;
    return need;
}

/// Of the annunciations.
float strip_height(float width, float t) {
    const float texts = width < kTextsForOneRow * t ? kStripOfTwoRows : kStrip;
    // The phase and its source take two rows of the smallest text.
    const float rows = t < kMinText_px ? 2 * kStripRowEms * kMinText_px + kStripEdges * t : 0;
    return std::max(texts * t, rows);
}

/// Tapes at the sides, the legends' column beside the airspeed, and the attitude between them.
void add_columns(Layout& layout, const LegendNeed& need, float top, float tall) {
    const float t = layout.text_px, margin = kMargin * t, gap = kGap * t, right = layout.screen.right() - margin;
    layout.airspeed = {margin, top, kAirspeedWidth * t, tall};
    const float altitude = std::max(kAltitudeWidth * t, kAltitudeEms * kMinText_px + kPointer * t);
    // As wide as its number asks for, if the view keeps its middle beside the columns.
    const float room = right - layout.screen.center().x - kMinHalfView * t - 2 * gap - altitude;
    const float narrow = kVerticalSpeedWidth * t, number = kVerticalSpeedEms * kMinText_px;
    const float speed = room < number ? narrow : std::max(narrow, number);
    layout.vertical_speed = {right - speed, top, speed, tall};
    layout.altitude = {layout.vertical_speed.x - gap - altitude, top, altitude, tall};
    const float beside_airspeed = layout.airspeed.right() + gap;
    if (need.has_column()) layout.legend = {beside_airspeed, top, legend_width(layout, beside_airspeed), tall};
    const float left = need.has_column() ? layout.legend.right() + gap : beside_airspeed;
    layout.attitude = {left, top, layout.altitude.x - gap - left, tall};
}

/// Below the tapes, from the left: the height above ground, the altimeter's setting and, where the column of vertical speeds is
/// too narrow for it, their number.
void add_foot(Layout& layout, float top, float height) {
    const float t = layout.text_px, margin = kMargin * t, gap = kGap * t, right = layout.screen.right() - margin;
    layout.ground_height = {margin, top, std::max(kAirspeedWidth * t, kGroundHeightEms * kMinText_px), height};
    layout.baro_setting = {layout.altitude.x, top, right - layout.altitude.x, height};
    const float number = kVerticalSpeedEms * kMinText_px;
    if (layout.vertical_speed.width >= number) return;
    layout.vertical_speed_number = {right - number, top, number, height};
    const float baro_right = layout.vertical_speed_number.x - gap;
    const float baro = std::max(baro_right - layout.altitude.x, kBaroEms * kMinText_px);
    layout.baro_setting = {baro_right - baro, top, baro, height};
}

}  // namespace

Layout make_layout(std::uint32_t width, std::uint32_t height, double dpi, const LegendNeed& asked) noexcept {
    Layout layout;
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const float t = text_size(w, h, dpi);
    const LegendNeed need = fitting_need(asked, t);
    layout.has_legend_rows = need.has_legends();
    const float margin = kMargin * t, gap = kGap * t;
    layout.text_px = t;
    layout.stroke_px = std::max(1.25f, t * 0.1f);
    layout.screen = {0, 0, w, h};

    layout.annunciations = {0, 0, w, strip_height(w, t)};
    const float information = legible_row_px(kInformation, t);
    const float information_middle = h - std::max(margin + kInformation * t / 2, information / 2);
    layout.information = {margin, information_middle - information / 2, w - 2 * margin, information};

    const float foot = std::max(kBottomRow * t, 2 * kMinRowEms * kMinText_px);  // a label over a number
    const float bottom_row = layout.information.y - gap - foot;
    const float top = layout.annunciations.bottom() + gap;
    add_columns(layout, need, top, bottom_row - gap - top);
    add_foot(layout, bottom_row, foot);
    const bool is_rose_below = has_rose_below_columns(w, h, t);
    if (is_rose_below) add_rose_below(layout, bottom_row - gap);
    if (need.adjacent.maps > 0) add_adjacent(layout, need);
    if (need.data.entries > 0) add_data_legends(layout, need);
    if (!is_rose_below) add_rose(layout);
    if (need.key_entries > 0) add_key(layout, need.key_entries);
    add_air(layout);
    const float deviation = kDeviationHeight * t + 2 * (legible_row_px(kDeviationName, t) - kDeviationName * t);
    layout.vertical_deviation = {layout.attitude.right() - kDeviationWidth * t, (h - deviation) / 2, kDeviationWidth * t,
                                 deviation};
    return layout;
}

Rect conformal_box(const Layout& layout) noexcept {
    const Rect& box = layout.attitude;
    return {box.x, box.y, box.width, layout.heading.bottom() - box.y};
}

}  // namespace tedavis::draw
