#include "render_core/raytrace/height_mipmap.hpp"

#include <algorithm>

#include "render_core/base/check.hpp"

namespace tedavis::raytrace {
namespace {

constexpr int kBandLevels = 6;  // built together: what a band of 2^6 rows of cells has, stays in a cache

std::uint32_t half_of_nodes(std::uint32_t nodes) { return nodes / 2 + nodes % 2; }

template <class Height, HeightBound bound>
Height outer_of(Height a, Height b) {
    if constexpr (bound == HeightBound::maximum) return a < b ? b : a;
    return b < a ? b : a;
}

template <class Height, HeightBound bound>
void bound_cells(const HeightGrid<Height>& grid, std::uint32_t row, std::uint32_t first, std::uint32_t end, Height* nodes) {
    const Height* const upper = grid.row(row);
    const Height* const lower = grid.row(row + 1);
    for (std::uint32_t n = first; n < end; ++n) {
        const Height a = upper[n], b = upper[n + 1], c = lower[n], d = lower[n + 1];
        const Height least = std::min(std::min(a, b), std::min(c, d));
        const Height all = bound == HeightBound::maximum ? std::max(std::max(a, b), std::max(c, d)) : least;
        nodes[n] = least == HeightGrid<Height>::kVoid ? no_surface<Height>(bound) : all;
    }
}

/// One row of a level from the two below it, which may be the same.
template <class Height, HeightBound bound>
void bound_nodes(const Height* upper, const Height* lower, std::uint32_t columns, std::uint32_t first, std::uint32_t end,
                 Height* nodes) {
    const std::uint32_t whole = std::min(end, columns / 2);
    for (std::uint32_t n = first; n < whole; ++n) {
        const Height left = outer_of<Height, bound>(upper[2 * n], lower[2 * n]);
        const Height right = outer_of<Height, bound>(upper[2 * n + 1], lower[2 * n + 1]);
        nodes[n] = outer_of<Height, bound>(left, right);
    }
    if (end > whole) nodes[end - 1] = outer_of<Height, bound>(upper[columns - 1], lower[columns - 1]);
}

/// Nodes of all levels.
std::uint64_t lay_out(std::uint32_t columns, std::uint32_t rows, MipmapLayout& layout) {
    std::uint64_t nodes = 0;
    std::uint32_t across = columns - 1, down = rows - 1;
    for (int n = 0; n < MipmapLayout::kMaxLevels; ++n) {
        layout.top = n;
        layout.first[n] = static_cast<std::int32_t>(nodes);
        layout.columns[n] = static_cast<std::int32_t>(across);
        layout.rows[n] = static_cast<std::int32_t>(down);
        nodes += std::uint64_t{across} * down;
        if (across == 1 && down == 1) break;
        across = half_of_nodes(across);
        down = half_of_nodes(down);
    }
    return nodes;
}

}  // namespace

template <class Height>
std::uint64_t HeightMipmap<Height>::bytes_needed(std::uint32_t columns, std::uint32_t rows) {
    MipmapLayout layout;
    return (lay_out(columns, rows, layout) + 1) * sizeof(Height) + alignof(Height);
}

template <class Height>
bool HeightMipmap<Height>::start(const HeightGrid<Height>& grid, base::Arena& arena, const CellBounds<Height>& cells) {
    TEDAVIS_CHECK(grid.is_valid());
    grid_ = grid;
    cells_ = cells;
    nodes_ = arena.allocate_array<Height>(static_cast<std::size_t>(lay_out(grid.columns, grid.rows, layout_)) + 1);
    return !nodes_.empty();
}

template <class Height>
MipmapLevel<Height> HeightMipmap<Height>::level(std::uint32_t n) const {
    const int at = static_cast<int>(n);
    return {row_of(at, 0), across(at), down(at)};
}

template <class Height>
Height* HeightMipmap<Height>::row_of(int level, std::uint32_t row) const {
    return nodes_.data() + layout_.first[level] + std::size_t{row} * across(level);
}

template <class Height>
void HeightMipmap<Height>::bound_row(int level, std::uint32_t row, std::uint32_t first, std::uint32_t end) {
    Height* const nodes = row_of(level, row);
    const bool is_maximum = bound_ == HeightBound::maximum;
    if (level == 0) {
        if (cells_.row != nullptr) return cells_.row(cells_.context, grid_, bound_, row, first, end, nodes);
        is_maximum ? bound_cells<Height, HeightBound::maximum>(grid_, row, first, end, nodes)
                   : bound_cells<Height, HeightBound::minimum>(grid_, row, first, end, nodes);
        return;
    }
    const Height* const upper = row_of(level - 1, 2 * row);
    const Height* const lower = row_of(level - 1, std::min(2 * row + 1, down(level - 1) - 1));
    const std::uint32_t columns = across(level - 1);
    is_maximum ? bound_nodes<Height, HeightBound::maximum>(upper, lower, columns, first, end, nodes)
               : bound_nodes<Height, HeightBound::minimum>(upper, lower, columns, first, end, nodes);
}

template <class Height>
void HeightMipmap<Height>::build_band(std::uint32_t band) {
    const std::uint32_t first = band << kBandLevels;
    const std::uint32_t end = std::min(first + (1u << kBandLevels), down(0));
    // A row of a level is made as soon as the rows below it are there.
    for (std::uint32_t row = first; row < end; ++row) {
        bound_row(0, row, 0, across(0));
        const bool is_last = row + 1 == end;
        for (int level = 1; level <= kBandLevels && level <= layout_.top; ++level) {
            const std::uint32_t parts = 1u << level;
            if ((row + 1) % parts != 0 && !is_last) break;
            bound_row(level, row >> level, 0, across(level));
        }
    }
}

template <class Height>
void HeightMipmap<Height>::build(base::Workers& workers) {
    const std::uint32_t bands = (down(0) + (1u << kBandLevels) - 1) >> kBandLevels;
    workers.parallel_for(
        bands, [](void* self, std::uint32_t band) { static_cast<HeightMipmap*>(self)->build_band(band); }, this);
    for (int level = kBandLevels + 1; level <= layout_.top; ++level)
        for (std::uint32_t row = 0; row < down(level); ++row) bound_row(level, row, 0, across(level));
}

template <class Height>
void HeightMipmap<Height>::update(const PostRegion& changed) {
    TEDAVIS_CHECK(changed.end_column <= grid_.columns && changed.end_row <= grid_.rows);
    if (changed.first_column >= changed.end_column || changed.first_row >= changed.end_row) return;
    const std::uint32_t before = cells_.reach + 1;  // cells that a post takes part in
    std::uint32_t left = std::max(changed.first_column, before) - before;
    std::uint32_t right = std::min(changed.end_column + cells_.reach, across(0));
    std::uint32_t top = std::max(changed.first_row, before) - before;
    std::uint32_t bottom = std::min(changed.end_row + cells_.reach, down(0));
    for (int level = 0; level <= layout_.top; ++level) {
        for (std::uint32_t row = top; row < bottom; ++row) bound_row(level, row, left, right);
        left /= 2;
        top /= 2;
        right = half_of_nodes(right);
        bottom = half_of_nodes(bottom);
    }
}

template class HeightMipmap<std::int16_t>;
template class HeightMipmap<float>;

}  // namespace tedavis::raytrace
