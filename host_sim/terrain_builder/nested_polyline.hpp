/// The levels up to which posts of a line are vertices: nested simplifications of a profile.
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

/// Tolerance of borders as a fraction of the level's tolerance. It is smaller than that of meshes, since a mesh cannot be more
/// accurate than its border, and is less accurate between a chord and the posts of the next row. At level 1 borders have every
/// post that is not on a straight line. At higher levels the fraction is larger, since borders would use a growing share of the
/// fewer vertices.
[[nodiscard]] constexpr double border_tolerance(std::uint32_t level) {
    constexpr double kTolerances[] = {0, 0, 0.06, 0.12, 0.15, 0.2, 0.4};
    constexpr std::uint32_t kLast = sizeof kTolerances / sizeof kTolerances[0] - 1;
    return kTolerances[level < kLast ? level : kLast];
}
/// Largest number of inserted posts between two corners of the next finer level; with four sides of two halves each, at most a
/// third of a chunk's vertices.
inline constexpr std::uint32_t kMaxBorderInsertions = 127;

/// A piece of a line that consists of whole segments of its top level, so that it can be processed alone.
struct LinePiece {
    std::uint32_t first = 0;  ///< index of its first post in the whole line: a multiple of the top level's segment
    base::Span<const float> surface_m;
    base::Span<const terrain::PostClass> post_class;
    std::uint32_t top_level = 0;  ///< the highest level at which the line is a border
    /// Tolerance of the segment that begins at a post.
    std::function<double(std::uint32_t level, std::uint32_t post)> tolerance_m;
    base::Span<const std::uint8_t> kept;  ///< levels up to which posts are kept in any case; empty: none
    base::Span<const std::uint8_t> most;  ///< highest level at which a post may be kept otherwise; empty: any
    double sagitta_m = 0;  ///< sagitta of a chord between neighbouring posts; it grows with the square of the chord's posts
};

/// Returns for each post the highest level whose borders have it as a vertex. At level k these are every multiple of 16 * 2^k and
/// both ends, and, as far as the capacity allows, the posts between that are needed for no valid post to be farther from the
/// polyline than the tolerance and for each side over void posts to have a void end. Level 0 has every post.
[[nodiscard]] std::vector<std::uint8_t> keep_levels(const LinePiece& line);

}  // namespace tedavis::host_sim
