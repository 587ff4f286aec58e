#include "render_core/draw/symbology/key_plan.hpp"

#include <algorithm>

#include "render_core/draw/text_size.hpp"

namespace tedavis::draw {
namespace {

constexpr float kKeyText = 0.7f;  // texts
// In ems of the key's own text.
constexpr float kKeyWidth = 10.0f, kKeyHeight = 2.2f, kKeyGap = 0.2f;
constexpr float kPlaceSlack_px = 0.01f;

float length_of(std::size_t cells, float cell_px, float gap_px) {
    return cells == 0 ? 0 : static_cast<float>(cells) * (cell_px + gap_px) - gap_px;
}

std::size_t count_within(float length_px, float cell_px, float gap_px) {
    return static_cast<std::size_t>(std::max(0.0f, (length_px + gap_px + kPlaceSlack_px) / (cell_px + gap_px)));
}

}  // namespace

KeyCell key_cell(float text_px) noexcept {
    const float em = std::max(kKeyText * text_px, kMinText_px);
    return {em, kKeyWidth * em, kKeyHeight * em, kKeyGap * em};
}

Rect KeyPlan::cell_at(std::size_t n) const noexcept {
    const auto column = static_cast<float>(n % across), row = static_cast<float>(n / across);
    return {box.x + column * (cell.width_px + cell.gap_px), box.y + row * (cell.height_px + cell.gap_px), cell.width_px,
            cell.height_px};
}

KeyPlan plan_key(const Rect& room, KeyOrder order, std::size_t entries, float picture_px2, float text_px) noexcept {
    KeyPlan plan;
    plan.cell = key_cell(text_px);
    const KeyCell& cell = plan.cell;
    const std::size_t wide = count_within(room.width, cell.width_px, cell.gap_px),
                      high = count_within(room.height, cell.height_px, cell.gap_px);
    plan.across = order == KeyOrder::column ? std::min<std::size_t>(wide, 1) : wide;
    const auto box_of = [&](std::size_t count) {
        const std::size_t rows = (count + plan.across - 1) / plan.across;
        const float height = length_of(rows, cell.height_px, cell.gap_px);
        return Rect{room.x, order == KeyOrder::column ? room.bottom() - height : room.y,
                    length_of(std::min(count, plan.across), cell.width_px, cell.gap_px), height};
    };
    plan.cut = entries;
    for (std::size_t count = 1; count <= std::min(entries, plan.across * high); ++count) {
        const Rect box = box_of(count);
        if (box.width * box.height > kMaxKeyShare * picture_px2) break;
        plan.box = box;
        plan.shown = count;
        plan.cut = entries - count;
    }
    plan.across = std::max<std::size_t>(plan.across, 1);
    return plan;
}

}  // namespace tedavis::draw
