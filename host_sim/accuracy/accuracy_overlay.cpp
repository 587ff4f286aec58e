#include "host_sim/accuracy/accuracy_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "host_sim/reports/picture_text.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

constexpr float kTextSize_px = 11, kLine_px = 15;
constexpr std::uint32_t kMargin_px = 5;
constexpr std::array<std::uint8_t, 3> kInk = {255, 255, 255}, kPaper = {16, 16, 16};
constexpr std::uint32_t kLegendHeight_px = 10, kLegendSteps = 32;

/// Two digits behind the point, and never below the value.
std::string rounded_up(double px) {
    if (!std::isfinite(px)) return "unknown";
    char text[32];
    std::snprintf(text, sizeof text, "%.2f px", std::ceil(px * 100 - 1e-9) / 100);
    return text;
}

struct Panel {
    std::uint32_t left, top, width, height;
};

/// Opaque, so that its text is read over any picture.
void fill(RgbaPicture& picture, const Panel& panel, const std::array<std::uint8_t, 3>& color) {
    for (std::uint32_t y = panel.top; y < std::min(panel.top + panel.height, picture.height); ++y)
        for (std::uint32_t x = panel.left; x < std::min(panel.left + panel.width, picture.width); ++x)
            std::copy(color.begin(), color.end(), &picture.pixels[(std::size_t{y} * picture.width + x) * 4]);
}

float widest_of(const std::vector<std::string>& lines) {
    float widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, draw::text_width_px(line, kTextSize_px));
    return widest;
}

std::vector<std::string> map_lines(const MeasuredError& error) {
    if (error.places == 0) return {"NO GROUND MEASURED HERE"};
    return {"MEASURED MAX " + rounded_up(error.max_px)};
}

/// The colors of errors from 0 to `full_px` beside each other, with both ends named.
void draw_legend(RgbaPicture& picture, const Panel& room, double full_px) {
    const std::uint32_t step = std::max(room.width / kLegendSteps, 1u);
    for (std::uint32_t n = 0; n < kLegendSteps; ++n)
        fill(picture, {room.left + n * step, room.top, step, kLegendHeight_px},
             error_color(full_px * n / (kLegendSteps - 1), full_px));
    const std::string end = rounded_up(full_px);
    const float baseline = static_cast<float>(room.top + kLegendHeight_px) + kTextSize_px;
    const auto left = static_cast<float>(room.left), width = static_cast<float>(step * kLegendSteps);
    draw_text(picture, "0", left, baseline, {kTextSize_px, kInk});
    draw_text(picture, end, left + width - draw::text_width_px(end, kTextSize_px), baseline, {kTextSize_px, kInk});
}

/// On the left, beside the legends.
void draw_panel(RgbaPicture& picture, const std::vector<std::string>& lines, const double* full_px) {
    constexpr std::uint32_t kLegendRoom_px = kLegendHeight_px + 20, kMinWidth_px = 4 * kLegendSteps;
    const std::uint32_t text_width = std::max(static_cast<std::uint32_t>(std::ceil(widest_of(lines))), kMinWidth_px);
    Panel panel{kMargin_px, picture.height / 8, text_width + 2 * kMargin_px,
                static_cast<std::uint32_t>(kLine_px * static_cast<float>(lines.size())) + kMargin_px};
    if (full_px != nullptr) panel.height += kLegendRoom_px;
    fill(picture, panel, kPaper);
    const std::uint32_t left = panel.left + kMargin_px;
    float baseline = static_cast<float>(panel.top) + kLine_px;
    for (const std::string& line : lines) {
        draw_text(picture, line, static_cast<float>(left), baseline, {kTextSize_px, kInk});
        baseline += kLine_px;
    }
    if (full_px != nullptr) draw_legend(picture, {left, panel.top + panel.height - kLegendRoom_px, text_width, 0}, *full_px);
}

/// Takes over the colored pixels where nothing is drawn over the terrain, so that data and symbology stay as they are. The
/// session shows its whole frame again afterwards.
void color_bare_ground(RgbaPicture& picture, const RgbaPicture& colored, DisplaySession& session) {
    session.draw_up_to(display::PictureLayer::terrain);
    const RgbaPicture bare = upright(session.pixels());
    session.draw_up_to(display::PictureLayer::symbology);
    for (std::size_t n = 0; n < picture.pixels.size(); n += 4)
        if (std::equal(&picture.pixels[n], &picture.pixels[n] + 3, &bare.pixels[n]))
            std::copy_n(&colored.pixels[n], 3, &picture.pixels[n]);
}

}  // namespace

std::vector<std::string> accuracy_lines(const FrameResult& result, bool has_time) {
    const display::TerrainRecord& terrain = result.record.terrain;
    std::vector<std::string> lines;
    if (terrain.chunks == 0) lines.emplace_back("NO TRIANGLES OF TERRAIN");
    if (terrain.chunks > 0) {
        lines.push_back("TAU " + rounded_up(terrain.tau_px));
        lines.push_back("PROVEN MAX " + rounded_up(terrain.worst_error_px));
    }
    lines.push_back("QUALITY LEVEL " + std::to_string(result.record.governor.quality_level));
    char time[40];
    std::snprintf(time, sizeof time, "FRAME %.1f ms", result.timing.total_ms);
    if (has_time) lines.emplace_back(time);
    return lines;
}

AccuracyOverlay::AccuracyOverlay(const OverlayStyle& style, std::string terrain) : style_(style), terrain_(std::move(terrain)) {
    show(style.shown);
}

void AccuracyOverlay::show(const AccuracyShown& shown) {
    if (shown.error_map && ground_ == nullptr) {
        if (terrain_.empty()) throw UserError("--error-map: needs terrain, whose error it shows; name one with --terrain");
        base::SerialWorkers alone;
        auto ground = std::make_unique<TracedGround>(terrain_, alone);
        if (ground->is_paged())
            throw UserError(terrain_ +
                            ": is too large for --error-map, which needs all heights in memory; cut a part of it with 'terrain "
                            "build --bounds W,S,E,N'");
        ground_ = std::move(ground);
    }
    style_.shown = shown;
}

RgbaPicture AccuracyOverlay::over(DisplaySession& session, FrameResult& result) const {
    RgbaPicture picture = upright(session.pixels());
    std::vector<std::string> lines;
    if (style_.shown.figures) lines = accuracy_lines(result, style_.has_time);
    const double full_px = result.record.terrain.tau_px;
    const bool has_scale = style_.shown.error_map && full_px > 0;
    if (style_.shown.error_map) {
        const GroundErrors errors = ground_errors(*ground_, session.display(), style_.cell_px);
        result.measured_error = errors.summary();
        if (has_scale) {
            RgbaPicture colored = picture;
            draw_ground_errors(colored, errors, full_px, style_.map);
            color_bare_ground(picture, colored, session);
        }
        for (const std::string& line : map_lines(*result.measured_error)) lines.push_back(line);
    }
    if (!lines.empty()) draw_panel(picture, lines, has_scale ? &full_px : nullptr);
    result.has_accuracy_overlay = style_.shown.any();
    return picture;
}

}  // namespace tedavis::host_sim
