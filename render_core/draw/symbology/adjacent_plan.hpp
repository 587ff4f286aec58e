/// Places square maps in a panel: a caption, and rows of maps below it. Lengths without a suffix are in text sizes, those with
/// `_px` and rectangles in pixels.
///
/// Memory  none is allocated. Thread  any; the functions are pure. Failure  none.
#pragma once

#include <cstdint>

#include "render_core/draw/rect.hpp"

namespace tedavis::draw {

/// The maps that a frame requests.
struct AdjacentNeed {
    std::uint32_t maps = 0;  ///< number of maps; 0: there is no panel
    float size = 0;          ///< largest side of a map
};

inline constexpr std::uint32_t kMaxMapsAcross = 3;
inline constexpr float kAdjacentCaption = 1.7f, kAdjacentGap = 0.15f;

/// Returns the number of maps in a row, 1 to kMaxMapsAcross: the smallest for which no map of a panel of this width is larger
/// than `need.size`.
[[nodiscard]] std::uint32_t maps_across(const AdjacentNeed& need, float width) noexcept;
/// Returns the height of a panel of this width with its caption.
[[nodiscard]] float adjacent_height(std::uint32_t maps, std::uint32_t across, float width) noexcept;

/// The placement of the maps in a panel.
struct AdjacentPlan {
    Rect maps;                        ///< area of all maps, below the caption
    std::uint32_t across = 1;         ///< maps in a row
    float side_px = 0, pitch_px = 0;  ///< side of a map, and distance between the left edges of two; whole pixels

    /// Returns the square of the n-th map, counted row by row from 0.
    [[nodiscard]] Rect box_of(std::uint32_t n) const {
        const std::uint32_t row = n / across, column = n % across;
        return {maps.x + pitch_px * static_cast<float>(column), maps.y + pitch_px * static_cast<float>(row), side_px, side_px};
    }
};
/// Returns the placement with the largest maps, and so the fewest in a row, for which the panel is high enough.
[[nodiscard]] AdjacentPlan plan_adjacent(const Rect& panel, std::uint32_t maps, float text_px) noexcept;

}  // namespace tedavis::draw
