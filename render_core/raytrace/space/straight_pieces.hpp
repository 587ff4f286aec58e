/// Rays of the world as straight pieces of grid space.
///
/// Over a stretch s a ray bends away from its chord by s^2 / 8R or less, R being the radius of what bends it most: the Earth, or
/// at high latitudes the parallel. Each piece is the line through the ray at the two nodes of Chebyshev on it, so that it is off
/// by half of that, alike at its ends and in its middle. What is off by e metres at a distance t is off by an angle of e / t: so
/// pieces may grow with the root of the distance. Neighbouring pieces do not meet exactly; `gap_steps` bounds what lies between
/// them, so that nobody slips through there (Ray::gap).
///
/// Pure, bounded; any thread.
#pragma once

#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/space/ground_space.hpp"

namespace tedavis::raytrace {

/// Times at which rays are cut, in metres along the direction that they are measured in.
struct PieceEnds {
    static constexpr int kMost = 48;

    double end[kMost + 1] = {};  ///< the first is 0
    int count = 0;               ///< of pieces
    double angle_rad = 0;        ///< that pieces are off by, at most

    [[nodiscard]] double most_off_m(int piece) const { return angle_rad * end[piece]; }
};

/// To a distance, or as far as kMost pieces go; `angle_rad`: what they may be off by, of the ray's own direction; a ray may be
/// longer than t says by `stretch`, the length of the longest direction.
[[nodiscard]] PieceEnds cut_rays(const earth::Ecef& from, double angle_rad, double stretch, double far_m);

/// A line of grid space: origin + t * direction.
struct StraightPiece {
    glm::dvec3 origin{0}, direction{0};
};

/// The piece from one time to another; the first one (`from` 0) begins where the ray begins.
[[nodiscard]] StraightPiece straight_piece(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction,
                                           double from, double to);

/// A piece of a ray for trace_ray().
[[nodiscard]] Ray ray_of(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction, const PieceEnds& ends,
                         int piece);

}  // namespace tedavis::raytrace
