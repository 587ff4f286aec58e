/// Counters of drawing the terrain. Plain data.
#pragma once

#include <cstdint>

namespace tedavis::draw {

struct TerrainDrawResult {
    std::uint32_t triangles = 0;
    std::uint32_t draws = 0;
};

}  // namespace tedavis::draw
