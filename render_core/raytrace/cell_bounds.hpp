/// Computes the bounds of each cell's surface: level 0 of a HeightMipmap.
#pragma once

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::raytrace {

enum class HeightBound : std::uint8_t { maximum, minimum };

/// The bound of a cell without a surface.
template <class Height>
[[nodiscard]] constexpr Height no_surface(HeightBound bound) {
    return bound == HeightBound::maximum ? std::numeric_limits<Height>::lowest() : std::numeric_limits<Height>::max();
}

template <class Height>
struct CellBounds {
    /// Writes the bounds of the cells [first, end) of a row to nodes[first] and following; called by several threads for
    /// different rows.
    using Row = void (*)(const void* context, const HeightGrid<Height>& grid, HeightBound bound, std::uint32_t row,
                         std::uint32_t first, std::uint32_t end, Height* nodes);
    Row row = nullptr;              ///< null: the bounds of the cell's four posts
    const void* context = nullptr;  ///< borrowed; must outlive the use
    std::uint32_t reach = 0;        ///< number of posts beyond a cell's own on which its bound depends
};

}  // namespace tedavis::raytrace
