#include "host_sim/reports/callouts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/reports/picture_text.hpp"
#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

constexpr float kMaxText_px = 15;
constexpr float kRowTexts = 1.3f;  // from a name to the next one
constexpr float kGap_px = 8;       // between a name and its line, and the edges
constexpr float kDot_px = 3;

using Order = std::vector<std::size_t>;

/// Numbers of the callouts on one side, from the top down.
Order side_of(const std::vector<Callout>& callouts, bool is_left) {
    Order by_x(callouts.size());
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::stable_sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return callouts[a].at.x < callouts[b].at.x; });
    const auto half = by_x.begin() + static_cast<std::ptrdiff_t>((by_x.size() + 1) / 2);
    Order side = is_left ? Order(by_x.begin(), half) : Order(half, by_x.end());
    std::stable_sort(side.begin(), side.end(), [&](std::size_t a, std::size_t b) { return callouts[a].at.y < callouts[b].at.y; });
    return side;
}

/// Middles of rows, each as near to its place as the others let it.
std::vector<float> rows_of(const Order& side, const std::vector<Callout>& callouts, float row_px, float height) {
    std::vector<float> rows;
    float above = -row_px / 2;
    for (const std::size_t n : side) rows.push_back(above = std::max(callouts[n].at.y, above + row_px));
    float below = height + row_px / 2;
    for (std::size_t n = rows.size(); n-- > 0;) rows[n] = below = std::min(rows[n], below - row_px);
    return rows;
}

void dot(RgbaPicture& picture, float x, float y, float radius, std::uint8_t grey) {
    for (int dy = -5; dy <= 5; ++dy)
        for (int dx = -5; dx <= 5; ++dx) {
            const auto px = static_cast<std::int64_t>(std::floor(x)) + dx, py = static_cast<std::int64_t>(std::floor(y)) + dy;
            if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
            if (std::hypot(static_cast<float>(dx), static_cast<float>(dy)) > radius) continue;
            std::uint8_t* const pixel =
                &picture.pixels[(static_cast<std::size_t>(py) * picture.width + static_cast<std::size_t>(px)) * 4];
            pixel[0] = pixel[1] = pixel[2] = grey;
        }
}

void line(RgbaPicture& picture, const PlacedCallout& placed, float radius, std::uint8_t grey) {
    const float dx = placed.to.x - placed.from.x, dy = placed.to.y - placed.from.y;
    const int steps = static_cast<int>(std::ceil(std::max(std::fabs(dx), std::fabs(dy)))) + 1;
    for (int n = 0; n <= steps; ++n) {
        const float share = static_cast<float>(n) / static_cast<float>(steps);
        dot(picture, placed.from.x + share * dx, placed.from.y + share * dy, radius, grey);
    }
}

RgbaPicture between_margins(const RgbaPicture& picture, std::uint32_t margin_px) {
    RgbaPicture wide{picture.width + 2 * margin_px, picture.height, {}};
    wide.pixels.assign(std::size_t{wide.width} * wide.height * 4, 255);
    for (std::uint32_t y = 0; y < picture.height; ++y)
        std::copy_n(&picture.pixels[std::size_t{y} * picture.width * 4], std::size_t{picture.width} * 4,
                    &wide.pixels[(std::size_t{y} * wide.width + margin_px) * 4]);
    return wide;
}

}  // namespace

CalloutLayout lay_out_callouts(const std::vector<Callout>& callouts, std::uint32_t width, std::uint32_t height) {
    CalloutLayout layout;
    const auto rows = static_cast<float>(std::max<std::size_t>(1, (callouts.size() + 1) / 2));
    const auto high = static_cast<float>(height), wide = static_cast<float>(width);
    layout.text_px = std::min(kMaxText_px, high / rows / kRowTexts);
    float widest = 0;
    for (const Callout& callout : callouts) widest = std::max(widest, draw::text_width_px(callout.name, layout.text_px));
    layout.margin_px = static_cast<std::uint32_t>(std::ceil(widest + 3 * kGap_px));
    layout.placed.resize(callouts.size());
    const auto margin = static_cast<float>(layout.margin_px);
    for (const bool is_left : {true, false}) {
        const Order side = side_of(callouts, is_left);
        const std::vector<float> middles = rows_of(side, callouts, kRowTexts * layout.text_px, high);
        for (std::size_t row = 0; row < side.size(); ++row) {
            const Callout& callout = callouts[side[row]];
            const float text_width = draw::text_width_px(callout.name, layout.text_px);
            const float x = is_left ? margin - 2 * kGap_px - text_width : margin + wide + 2 * kGap_px;
            PlacedCallout& placed = layout.placed[side[row]];
            placed.text = {x, middles[row] + 0.35f * layout.text_px};
            placed.from = {is_left ? margin - 1.5f * kGap_px : margin + wide + 1.5f * kGap_px, middles[row]};
            placed.to = {margin + callout.at.x, callout.at.y};
            placed.is_left = is_left;
        }
    }
    return layout;
}

RgbaPicture draw_callouts(const RgbaPicture& picture, const std::vector<Callout>& callouts) {
    const CalloutLayout layout = lay_out_callouts(callouts, picture.width, picture.height);
    RgbaPicture wide = between_margins(picture, layout.margin_px);
    for (const PlacedCallout& placed : layout.placed) line(wide, placed, 1, 255);
    for (const PlacedCallout& placed : layout.placed) line(wide, placed, 0, 0);
    for (const PlacedCallout& placed : layout.placed) {
        dot(wide, placed.to.x, placed.to.y, kDot_px + 1, 255);
        dot(wide, placed.to.x, placed.to.y, kDot_px, 0);
    }
    PictureTextStyle style;
    style.size_px = layout.text_px;
    for (std::size_t n = 0; n < callouts.size(); ++n)
        draw_text(wide, callouts[n].name, layout.placed[n].text.x, layout.placed[n].text.y, style);
    return wide;
}

}  // namespace tedavis::host_sim
