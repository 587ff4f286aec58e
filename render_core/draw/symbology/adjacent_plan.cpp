#include "render_core/draw/symbology/adjacent_plan.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::draw {
namespace {

constexpr float kRoundingShare = 0.01f;

float side_of(std::uint32_t across, float width) {
    return (width - kAdjacentGap * static_cast<float>(across - 1)) / static_cast<float>(across);
}

}  // namespace

std::uint32_t maps_across(const AdjacentNeed& need, float width) noexcept {
    std::uint32_t across = 1;
    while (across < std::min(need.maps, kMaxMapsAcross) && side_of(across, width) > need.size + kRoundingShare) ++across;
    return across;
}

float adjacent_height(std::uint32_t maps, std::uint32_t across, float width) noexcept {
    const std::uint32_t rows = (maps + across - 1) / across;
    return kAdjacentCaption + static_cast<float>(rows) * (side_of(across, width) + kAdjacentGap);
}

AdjacentPlan plan_adjacent(const Rect& panel, std::uint32_t maps, float text_px) noexcept {
    AdjacentPlan plan;
    const float width = panel.width / text_px, height = panel.height / text_px;
    while (plan.across < kMaxMapsAcross && adjacent_height(maps, plan.across, width) > height + kRoundingShare) ++plan.across;
    plan.maps = {std::ceil(panel.x), std::ceil(panel.y + kAdjacentCaption * text_px), panel.width, panel.height};
    plan.maps.width = panel.right() - plan.maps.x;
    plan.maps.height = panel.bottom() - plan.maps.y;
    plan.side_px = std::floor(side_of(plan.across, plan.maps.width / text_px) * text_px);
    plan.pitch_px = plan.side_px + std::floor(kAdjacentGap * text_px);
    return plan;
}

}  // namespace tedavis::draw
