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
    static constexpr int kMax = 48;

    double end[kMax + 1] = {};  ///< the first is 0
    int count = 0;              ///< of pieces
    double angle_rad = 0;       ///< that pieces are off by, at most

    [[nodiscard]] double most_off_m(int piece) const { return angle_rad * end[piece]; }
};

/// To a distance, or as far as kMax pieces go; `angle_rad`: what they may be off by, of the ray's own direction; a ray may be
/// longer than t says by `stretch`, the length of the longest direction.
[[nodiscard]] PieceEnds cut_rays(const earth::Ecef& from, double angle_rad, double stretch, double far_m);

/// A line of grid space: origin + t * direction.
struct StraightPiece {
    glm::dvec3 origin{0}, direction{0};
};

/// The piece from one time to another; the first one (`from` 0) begins where the ray begins.
[[nodiscard]] StraightPiece straight_piece(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction,
                                           double from, double to);

/// What single rays of the world may be off by.
inline constexpr double kSingleOff_rad = 5e-5;

/// Traces a ray of grid space as the ray of the world that it is where it begins: `trace` takes Rays, one piece after the other,
/// and gives something with `side` and `t`. No further than 400 km, nor than where it has risen above `highest` for good.
template <class Trace>
[[nodiscard]] auto trace_bent(const GroundSpace& space, const Ray& ray, double highest, const Trace& trace)
    -> decltype(trace(ray));

/// A piece of a ray for trace_ray().
[[nodiscard]] Ray ray_of(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction, const PieceEnds& ends,
                         int piece);

template <class Trace>
auto trace_bent(const GroundSpace& space, const Ray& ray, double highest, const Trace& trace) -> decltype(trace(ray)) {
    constexpr double kFar_m = 400000, kSurelyRises = 1e-3;
    const WorldRay world = space.world_ray(ray.origin, glm::dvec3(ray.direction));
    const double from_m = static_cast<double>(ray.from) * world.metres_of_t,
                 to_m = static_cast<double>(ray.to) * world.metres_of_t;
    const PieceEnds ends = cut_rays(world.origin, kSingleOff_rad, 1, to_m < kFar_m ? to_m : kFar_m);
    auto met = decltype(trace(ray)){};
    for (int n = 0; n < ends.count; ++n) {
        if (ends.end[n + 1] <= from_m) continue;
        Ray piece = ray_of(space, world.origin, world.direction, ends, n);
        if (ends.end[n] < from_m) piece.from = static_cast<float>(from_m);
        const double height = piece.origin.z + static_cast<double>(piece.direction.z) * static_cast<double>(piece.from);
        if (height > highest && static_cast<double>(piece.direction.z) * space.step_m() > kSurelyRises) break;
        met = trace(piece);
        if (met.side != HitSide::none) break;
    }
    met.t = static_cast<decltype(met.t)>(static_cast<double>(met.t) / world.metres_of_t);
    return met;
}

}  // namespace tedavis::raytrace
