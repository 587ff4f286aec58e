/// The heights of a tile, prepared for the search of horizons: posts that are void or outside can neither raise nor lower a
/// horizon.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"
#include "host_sim/terrain_builder/attributes/lanes.hpp"

namespace tedavis::host_sim {

/// Value for "no height": below (or above) every horizon, and finite, so that unused lanes stay finite too.
inline constexpr float kNoHeight_m = 1e7f;
[[nodiscard]] inline bool is_height(float height_m) { return height_m > -0.5f * kNoHeight_m; }

/// Values at the posts and half way to the next post south and east.
enum HalfPost { at_post, half_south, half_east, kHalfPosts };
using HalfPlanes = std::array<std::vector<float>, kHalfPosts>;

/// Fills the half-way planes from the posts: the mean of two posts, or the one that is valid.
void fill_half_posts(HalfPlanes& planes, const std::vector<float>& validity, std::size_t stride);

struct HeightPlanes {
    explicit HeightPlanes(const AttributeTile& tile);

    /// Inner post (0,0) is at(0,0); columns and rows from -kAttributeApron on. Planes are padded, so that kLanes values can be
    /// read from any post.
    [[nodiscard]] std::size_t at(int column, int row) const {
        const int full_row = row + kAttributeApron, full_column = column + kAttributeApron;
        return static_cast<std::size_t>(full_row) * stride + static_cast<std::size_t>(full_column);
    }
    [[nodiscard]] double east_m(int row) const { return tile.east_m[index_of(0, row + kAttributeApron, 1)]; }

    const AttributeTile& tile;  ///< must outlive this object
    std::size_t stride;
    HalfPlanes high;              ///< metres; -kNoHeight_m where there is none
    HalfPlanes low;               ///< metres; +kNoHeight_m where there is none
    std::vector<float> validity;  ///< of posts: 1 or 0
};

}  // namespace tedavis::host_sim
