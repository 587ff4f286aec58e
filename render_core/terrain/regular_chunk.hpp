/// The order of posts among the vertices of a regular chunk (the border first, clockwise from the north-west corner, then the
/// others row by row), and the lattice posts that they are.
#pragma once

#include <cstdint>

namespace tedavis::terrain {

/// Numbers of posts across and down, 2 or more each.
struct RegularGrid {
    std::uint32_t columns = 0, rows = 0;

    [[nodiscard]] constexpr std::uint32_t border_count() const { return 2 * (columns + rows) - 4; }
    [[nodiscard]] constexpr std::uint32_t vertex_count() const { return columns * rows; }
    [[nodiscard]] constexpr std::uint32_t triangle_count() const { return 2 * (columns - 1) * (rows - 1); }

    [[nodiscard]] constexpr std::uint32_t index_of(std::uint32_t i, std::uint32_t j) const {
        if (j == 0) return i;
        if (i == columns - 1) return columns - 1 + j;
        if (j == rows - 1) return 2 * columns + rows - 3 - i;
        if (i == 0) return 2 * columns + 2 * rows - 4 - j;
        return border_count() + (j - 1) * (columns - 2) + (i - 1);
    }
};

/// Returns the grid of a regular chunk over `cells_i` x `cells_j` cells of the lattice: it has every 2^level-th post and the
/// last column and row.
[[nodiscard]] constexpr RegularGrid regular_grid(std::uint32_t cells_i, std::uint32_t cells_j, std::uint32_t level) {
    const std::uint32_t spacing = 1u << level;
    return {(cells_i + spacing - 1) / spacing + 1, (cells_j + spacing - 1) / spacing + 1};
}

/// Lattice posts from the chunk's north-west corner to column (or row) n of its grid.
[[nodiscard]] constexpr std::uint32_t regular_post(std::uint32_t n, std::uint32_t cells, std::uint32_t level) {
    const std::uint32_t post = n << level;
    return post < cells ? post : cells;
}

}  // namespace tedavis::terrain
