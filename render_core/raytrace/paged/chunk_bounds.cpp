#include "render_core/raytrace/paged/chunk_bounds.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

/// Nodes of all levels that have any.
std::uint32_t lay_out_chunks(std::uint32_t columns, std::uint32_t rows, MipmapLayout& layout) {
    std::int32_t nodes = 0, across = static_cast<std::int32_t>(columns - 1), down = static_cast<std::int32_t>(rows - 1);
    for (int n = 0; n < MipmapLayout::kMaxLevels; ++n) {
        layout.top = n;
        layout.first[n] = nodes;
        layout.columns[n] = across;
        layout.rows[n] = down;
        if (n >= kChunkLevel) nodes += across * down;
        if (n >= kChunkLevel && across == 1 && down == 1) break;
        across = (across + 1) / 2;
        down = (down + 1) / 2;
    }
    return static_cast<std::uint32_t>(nodes);
}

template <class Height>
void bound_blocks(const MipmapLayout& layout, int level, Height* maxima, Height* minima) {
    const std::int32_t across = layout.columns[level - 1], down = layout.rows[level - 1];
    for (std::int32_t row = 0; row < layout.rows[level]; ++row)
        for (std::int32_t column = 0; column < layout.columns[level]; ++column) {
            Height highest = no_surface<Height>(HeightBound::maximum), lowest = no_surface<Height>(HeightBound::minimum);
            for (std::int32_t y = 2 * row; y < std::min(2 * row + 2, down); ++y)
                for (std::int32_t x = 2 * column; x < std::min(2 * column + 2, across); ++x) {
                    const std::int32_t part = layout.first[level - 1] + y * across + x;
                    highest = std::max(highest, maxima[part]);
                    lowest = std::min(lowest, minima[part]);
                }
            const std::int32_t node = layout.first[level] + row * layout.columns[level] + column;
            maxima[node] = highest;
            minima[node] = lowest;
        }
}

}  // namespace

template <class Height>
std::uint64_t ChunkBounds<Height>::bytes_needed(std::uint32_t columns, std::uint32_t rows) {
    MipmapLayout layout;
    return 2 * ((std::uint64_t{lay_out_chunks(columns, rows, layout)} + 1) * sizeof(Height) + alignof(Height));
}

template <class Height>
typename ChunkBounds<Height>::Started ChunkBounds<Height>::start(ChunkHeights<Height>& heights, base::Arena& arena) {
    const std::size_t nodes = std::size_t{lay_out_chunks(heights.columns(), heights.rows(), layout_)} + 1;
    maxima_ = arena.allocate_array<Height>(nodes);
    minima_ = arena.allocate_array<Height>(nodes);
    if (maxima_.empty() || minima_.empty()) return Started::no_room;
    const std::size_t chunks = std::size_t{heights.chunk_columns()} * heights.chunk_rows();
    if (!heights.read_bounds(minima_.subspan(0, chunks), maxima_.subspan(0, chunks))) return Started::unreadable;
    for (std::size_t n = 0; n < chunks; ++n) {
        if (minima_[n] <= maxima_[n]) continue;
        maxima_[n] = no_surface<Height>(HeightBound::maximum);
        minima_[n] = no_surface<Height>(HeightBound::minimum);
    }
    for (int level = kChunkLevel + 1; level <= layout_.top; ++level) bound_blocks(layout_, level, maxima_.data(), minima_.data());
    return Started::yes;
}

template class ChunkBounds<std::int16_t>;
template class ChunkBounds<float>;

}  // namespace tedavis::raytrace
