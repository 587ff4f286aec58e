/// A rectangle of posts of one level of the attribute pyramid, with an apron of posts around it.
///
/// Level m of the pyramid has posts 2^m cells apart; a height of level m + 1 is the mean of valid heights of level m. All
/// reaches below are in posts of the tile's own level, so that a tile needs the same apron at every level; what lies
/// beyond comes from the level above (far_horizons.hpp).
#pragma once

#include <cstddef>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// Horizons are searched up to this many posts, along a row or a column, in each of the 16 directions.
inline constexpr int kHorizonReach = 16;
/// Bounced light comes from posts up to kHorizonReach away, which may be shadowed by posts up to kHorizonReach farther.
inline constexpr int kAttributeApron = 2 * kHorizonReach;
/// Local relief compares a post with the square that reaches this far to each side.
inline constexpr int kReliefReach = 8;

/// The index of a value in rows of `stride` values.
[[nodiscard]] constexpr std::size_t index_of(int column, int row, int stride) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(column);
}

/// Rows run from north to south, columns from west to east; in a polar cap these are the north and east of its grid, for
/// normals, horizons and the light alike. Posts that are void or outside may hold any height.
struct AttributeTile {
    int columns = 0, rows = 0;  ///< inner posts, whose attributes are computed; at least 1
    /// (columns + 2 kAttributeApron) by (rows + 2 kAttributeApron), the apron included.
    std::vector<float> height_m;
    std::vector<terrain::PostClass> post_class;
    std::vector<double> east_m;  ///< from post to post along each row, the apron's rows included; positive
    double north_m = 0;          ///< from post to post along a column; positive

    [[nodiscard]] int full_columns() const { return columns + 2 * kAttributeApron; }
    [[nodiscard]] int full_rows() const { return rows + 2 * kAttributeApron; }
};

/// The light that is baked into the light map. Its parts add up to at most 1 where nothing is bounced.
struct FixedLight {
    double azimuth_rad = base::radians(315);         ///< clockwise from north
    double elevation_rad = base::radians(20);        ///< low, so that valleys are in shadow and show bounced light
    double disc_radius_rad = base::radians(0.2665);  ///< the sun's mean; shadows are soft over the disc; positive
    double direct = 0.8;                             ///< on a surface that faces the light
    double sky = 0.2;                                ///< on level open ground
    double albedo = 0.25;                            ///< of all ground, for the bounce
};

}  // namespace tedavis::host_sim
