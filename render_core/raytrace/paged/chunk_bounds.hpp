/// The highest and lowest height of every chunk of 32 x 32 cells, and of blocks of 2^k x 2^k of them: the levels of a
/// HeightMipmap from kChunkLevel up, which stay in memory. A chunk's bounds may be wider than its heights; this only costs
/// time.
///
/// Memory  from an arena: about 8/3 of sizeof(Height) per chunk.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/paged/chunk_heights.hpp"

namespace tedavis::raytrace {

inline constexpr int kChunkLevel = 5;

template <class Height>
class ChunkBounds {
public:
    enum class Started : std::uint8_t { yes, no_room, unreadable };

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows);
    [[nodiscard]] Started start(ChunkHeights<Height>& heights, base::Arena& arena);

    /// Levels below kChunkLevel have no nodes.
    [[nodiscard]] const MipmapLayout& layout() const { return layout_; }
    [[nodiscard]] const Height* maxima() const { return maxima_.data(); }
    [[nodiscard]] const Height* minima() const { return minima_.data(); }
    /// Bounds of a chunk, by its number, row by row.
    [[nodiscard]] Height highest(std::uint32_t chunk) const { return maxima_[chunk]; }
    [[nodiscard]] Height lowest(std::uint32_t chunk) const { return minima_[chunk]; }

private:
    MipmapLayout layout_;
    base::Span<Height> maxima_, minima_;  ///< the chunks first; one element behind the last may be read
};

}  // namespace tedavis::raytrace
