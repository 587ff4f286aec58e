/// Which posts of a line stay at which level: nested simplifications of a profile.
///
/// Greedy insertion of the post with the largest error (Douglas, Peucker, Cartographica 10(2), 1973, in the order of Garland
/// and Heckbert 1995), from the coarsest level to the finest: the posts of a level contain those of every coarser one.
/// Deterministic; pure function; any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render_core/base/span.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// Borders keep closer than their level's meshes: a mesh can be no better than its border, and between a chord and the posts of
/// the next row it is worse. At level 1 they keep every post that is not on a straight line. Chunks of higher levels have fewer
/// vertices, of which borders would take an ever larger share. Of the level's tolerance.
[[nodiscard]] constexpr double border_tolerance(std::uint32_t level) {
    constexpr double kTolerances[] = {0, 0, 0.06, 0.12, 0.15, 0.2, 0.4};
    constexpr std::uint32_t kLast = sizeof kTolerances / sizeof kTolerances[0] - 1;
    return kTolerances[level < kLast ? level : kLast];
}
/// Between two corners of the level below; with four sides of two halves each a third of a chunk's vertices at most.
inline constexpr std::uint32_t kMaxBorderInsertions = 127;

/// A piece of a line: whole segments of its top level, so that it can be treated alone.
struct LinePiece {
    std::uint32_t first = 0;  ///< of its first post along the whole line: a multiple of the top level's segment
    base::Span<const float> surface_m;
    base::Span<const terrain::PostClass> post_class;
    std::uint32_t top_level = 0;                                                 ///< the highest at which the line is a border
    std::function<double(std::uint32_t level, std::uint32_t post)> tolerance_m;  ///< beside the segment that begins at a post
    base::Span<const std::uint8_t> kept;  ///< levels at which posts stay in any case; empty: none does
    base::Span<const std::uint8_t> most;  ///< the highest at which a post may stay of its own; empty: any
    double sagitta_m = 0;                 ///< of a chord from a post to the next: times the square of the posts for longer ones
};

/// A post of level k or above is a vertex of borders of level k. At level k every multiple of 16 * 2^k and both ends are; what
/// lies between them, as far as the capacity goes, so that no valid post is further from the polyline than the tolerance and
/// a side that passes void posts has a void end. Level 0 keeps every post.
[[nodiscard]] std::vector<std::uint8_t> keep_levels(const LinePiece& line);

}  // namespace tedavis::host_sim
