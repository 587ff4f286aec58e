#include "host_sim/window/window_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "host_sim/calendar_time.hpp"
#include "host_sim/reports/picture_text.hpp"
#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::array<std::uint8_t, 3> kOverlayPaper = {236, 236, 224}, kOverlayInk = {16, 16, 16};
struct SheetLook {
    float text_px, line_px;
    std::uint32_t margin_px;
};
constexpr SheetLook kLineLook = {11, 13, 3}, kPanelLook = {13, 17, 6};
/// Above this share of the paper's brightness a pixel is paper. Two colors alone make few rectangles.
constexpr std::uint8_t kPaperFrom = 140;

RgbaPicture sheet_of_paper(std::uint32_t width, std::uint32_t height) {
    RgbaPicture paper{width, height, std::vector<std::uint8_t>(std::size_t{width} * height * 4, 255)};
    for (std::size_t n = 0; n < paper.pixels.size(); n += 4)
        std::copy(kOverlayPaper.begin(), kOverlayPaper.end(), &paper.pixels[n]);
    return paper;
}

void leave_two_colors(RgbaPicture& picture) {
    for (std::size_t n = 0; n < picture.pixels.size(); n += 4) {
        const auto& color = picture.pixels[n] >= kPaperFrom ? kOverlayPaper : kOverlayInk;
        std::copy(color.begin(), color.end(), &picture.pixels[n]);
    }
}

/// A sheet of lines, its size as they need it, but no larger than the room.
RgbaPicture sheet_with(const std::vector<std::string>& lines, const SheetLook& look, std::uint32_t most_width,
                       std::uint32_t most_height) {
    const auto margins = static_cast<float>(2 * look.margin_px);
    float widest = 1;
    for (const std::string& line : lines) widest = std::max(widest, draw::text_width_px(line, look.text_px));
    const auto count = static_cast<float>(lines.size());
    const float scale = std::min({1.0f, (static_cast<float>(most_width) - margins) / widest,
                                  (static_cast<float>(most_height) - margins) / (count * look.line_px)});
    if (scale <= 0) return sheet_of_paper(0, 0);
    const auto size = [&](float text, std::uint32_t most) {
        return std::min(most, static_cast<std::uint32_t>(std::ceil(text * scale + margins)));
    };
    RgbaPicture sheet = sheet_of_paper(size(widest, most_width), size(count * look.line_px, most_height));
    float baseline = static_cast<float>(look.margin_px) + look.text_px * scale;
    for (const std::string& line : lines) {
        draw_text(sheet, line, static_cast<float>(look.margin_px), baseline, {look.text_px * scale, kOverlayInk});
        baseline += look.line_px * scale;
    }
    leave_two_colors(sheet);
    return sheet;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

void lay(const RgbaPicture& sheet, std::uint32_t left, std::uint32_t top, std::vector<PaintedRect>& rects) {
    if (sheet.pixels.empty()) return;
    rects.push_back({left, top, sheet.width, sheet.height, kOverlayPaper});
    for (PaintedRect ink : changed_rects(view_of(sheet_of_paper(sheet.width, sheet.height)), view_of(sheet))) {
        ink.left += left;
        ink.top += top;
        rects.push_back(ink);
    }
}

}  // namespace

std::string head_up_text(const HeadUp& head_up) {
    char text[160];
    std::snprintf(text, sizeof text, "%.2f / %.2f s  x%g%s%s", head_up.flight_s, head_up.last_s, head_up.speed,
                  head_up.is_backwards ? " backwards" : "", head_up.is_playing ? "" : "  PAUSED");
    std::string line = "WINDOW";
    if (head_up.time.is_date) line += "  " + utc_text(head_up.time.utc) + (head_up.time.is_confirmed ? "" : " (not confirmed)");
    line += std::string("\n") + text + "\nphase " + head_up.phase + "  design " + head_up.design;
    if (!head_up.camera.empty()) line += "  " + head_up.camera;
    return line;
}

std::vector<PaintedRect> overlay_rects(const WindowOverlay& overlay, std::uint32_t width_px, std::uint32_t height_px) {
    std::vector<PaintedRect> rects;
    std::uint32_t bottom = height_px;
    if (!overlay.line.empty()) {
        const RgbaPicture line = sheet_with(lines_of(overlay.line), kLineLook, width_px, height_px);
        bottom = height_px - line.height;
        lay(line, 0, bottom, rects);
    }
    if (!overlay.panel.empty()) {
        const RgbaPicture panel = sheet_with(overlay.panel, kPanelLook, width_px, bottom);
        lay(panel, (width_px - panel.width) / 2, (bottom - panel.height) / 2, rects);
    }
    return rects;
}

}  // namespace tedavis::host_sim
