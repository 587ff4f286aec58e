/// A square of generated terrain in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/fractal_terrain.hpp"

namespace tedavis::test_support {

struct FractalSquare {
    std::uint32_t posts = 0;  ///< a side
    std::vector<float> height_m;

    [[nodiscard]] float at(std::uint32_t i, std::uint32_t j) const { return height_m[std::size_t{j} * posts + i]; }
};

/// The posts from (first_i, first_j) on.
inline FractalSquare fractal_square(std::uint32_t posts, std::uint64_t seed, std::int32_t first_i = 0, std::int32_t first_j = 0) {
    FractalSquare square{posts, std::vector<float>(std::size_t{posts} * posts)};
    host_sim::FractalTerrain(seed).read(first_i, first_j, posts, posts, square.height_m);
    return square;
}

}  // namespace tedavis::test_support
