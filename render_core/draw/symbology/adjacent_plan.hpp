/// Layout of square maps in a panel: a caption, and below it rows of maps. Pure; any thread.
#pragma once

#include <cstdint>

#include "render_core/draw/rect.hpp"

namespace tedavis::draw {

/// The requested maps; sides are in text sizes.
struct AdjacentNeed {
    std::uint32_t maps = 0;  ///< 0: no panel
    float size = 0;          ///< largest side of a map
};

inline constexpr std::uint32_t kMaxMapsAcross = 3;
inline constexpr float kAdjacentCaption = 1.7f, kAdjacentGap = 0.15f;

/// Maps side by side, so that none is larger than wanted where the panel has this width in texts; 1 .. kMaxMapsAcross.
[[nodiscard]] std::uint32_t maps_across(const AdjacentNeed& need, float width) noexcept;
/// In texts, of a panel of this width.
[[nodiscard]] float adjacent_height(std::uint32_t maps, std::uint32_t across, float width) noexcept;

struct AdjacentPlan {
    Rect maps;  ///< below the caption
    std::uint32_t across = 1;
    float side_px = 0, pitch_px = 0;  ///< whole pixels

    /// Row by row.
    [[nodiscard]] Rect box_of(std::uint32_t n) const {
        const std::uint32_t row = n / across, column = n % across;
        return {maps.x + pitch_px * static_cast<float>(column), maps.y + pitch_px * static_cast<float>(row), side_px, side_px};
    }
};
/// With as few across, and so as large maps, as the panel is high enough for.
[[nodiscard]] AdjacentPlan plan_adjacent(const Rect& panel, std::uint32_t maps, float text_px) noexcept;

}  // namespace tedavis::draw
