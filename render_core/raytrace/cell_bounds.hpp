/// Who says how high, or low, the surface of each cell comes: level 0 of a HeightMipmap.
#pragma once

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::raytrace {

enum class HeightBound : std::uint8_t { maximum, minimum };

/// What a cell without a surface counts as.
template <class Height>
[[nodiscard]] constexpr Height no_surface(HeightBound bound) {
    return bound == HeightBound::maximum ? std::numeric_limits<Height>::lowest() : std::numeric_limits<Height>::max();
}

template <class Height>
struct CellBounds {
    /// Of the cells [first, end) of a row, to nodes[first] and on; called by several threads, each for other rows.
    using Row = void (*)(const void* context, const HeightGrid<Height>& grid, HeightBound bound, std::uint32_t row,
                         std::uint32_t first, std::uint32_t end, Height* nodes);
    Row row = nullptr;              ///< null: of the four posts of a cell
    const void* context = nullptr;  ///< borrowed; must stay
    std::uint32_t reach = 0;        ///< posts beyond a cell's own that its bound depends on
};

}  // namespace tedavis::raytrace
