#include "host_sim/terrain_builder/ground.hpp"

#include <algorithm>

namespace tedavis::host_sim {

using terrain::kChunkCells;

std::uint32_t LineGrid::post_of(std::uint32_t line) const { return std::min(line * kChunkCells, posts - 1); }

std::uint32_t LineGrid::top_level(std::uint32_t post) const {
    if (post == 0 || post == posts - 1) return top;
    std::uint32_t level = 0;
    while (level < top && post % (kChunkCells << (level + 1)) == 0) ++level;
    return level;
}

}  // namespace tedavis::host_sim
