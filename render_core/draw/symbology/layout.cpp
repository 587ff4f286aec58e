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

float text_size(float width, float height, double dpi) {
    const float ordinary = std::min(width, height) / kTextsAcrossShortSide;
    const float legible = static_cast<float>(kLegibleText_inch * dpi);
    return std::min({std::max(ordinary, legible), width / kTextsAcrossWidth, height / kTextsAcrossHeight});
}

}  // namespace

Layout make_layout(std::uint32_t width, std::uint32_t height, double dpi) noexcept {
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
    const float half = std::min(w / 2 - layout.attitude.x, layout.attitude.right() - w / 2);
    layout.heading = {w / 2 - half, bottom_row, 2 * half, kBottomRow * t};
    return layout;
}

}  // namespace tedavis::draw
