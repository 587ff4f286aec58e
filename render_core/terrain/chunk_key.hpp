/// Identifies a chunk by its level and its position in the level's grid.
#pragma once

#include <cstdint>

#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::terrain {

struct ChunkKey {
    std::uint32_t level = 0, i = 0, j = 0;

    [[nodiscard]] constexpr bool operator==(const ChunkKey& o) const { return level == o.level && i == o.i && j == o.j; }
    [[nodiscard]] constexpr bool operator!=(const ChunkKey& o) const { return !(*this == o); }
    /// A total order: coarse levels first, then row by row.
    [[nodiscard]] constexpr bool operator<(const ChunkKey& o) const {
        if (level != o.level) return level > o.level;
        return j != o.j ? j < o.j : i < o.i;
    }
    /// Unique; never 0 for a chunk of a database.
    [[nodiscard]] constexpr std::uint64_t packed() const {
        return (std::uint64_t{level + 1} << 56) | (std::uint64_t{j} << 28) | i;
    }
    [[nodiscard]] constexpr ChunkKey parent() const { return {level + 1, i / 2, j / 2}; }
    /// Bit 0 east, bit 1 south. Level must be 1 or more.
    [[nodiscard]] constexpr ChunkKey child(std::uint32_t quadrant) const {
        return {level - 1, 2 * i + (quadrant & 1u), 2 * j + (quadrant >> 1)};
    }
    /// The chunk's quadrant in its parent.
    [[nodiscard]] constexpr std::uint32_t quadrant() const { return (i & 1u) | ((j & 1u) << 1); }
};

inline constexpr ChunkKey kNoChunk{0xFF, 0, 0};

[[nodiscard]] constexpr ChunkKey key_of(const ChunkEntry& entry) { return {entry.level, entry.i, entry.j}; }

/// Sides of a chunk, one bit each.
enum EdgeBit : std::uint8_t { kEdgeNorth = 1, kEdgeEast = 2, kEdgeSouth = 4, kEdgeWest = 8 };

}  // namespace tedavis::terrain
