/// Divides rays of the world into straight pieces of grid space.
///
/// Over a length s a ray deviates from its chord by at most s^2 / 8R, R being the smallest radius involved: the Earth's, or at
/// high latitudes the parallel's. Each piece is the line through the ray's points at its two Chebyshev nodes, which halves the
/// deviation and makes it equal at the ends and in the middle. A deviation of e metres at a distance t is an angle of e / t, so
/// the length of pieces may grow with the root of the distance. Neighbouring pieces do not join exactly; `gap_steps` bounds the
/// gap, so that no ray passes through the surface there (Ray::gap).
///
/// Pure, bounded; any thread.
#pragma once

#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/space/ground_space.hpp"

namespace tedavis::raytrace {

/// The distances at which rays are divided, in metres along the measured direction.
struct PieceEnds {
    static constexpr int kMax = 48;

    double end[kMax + 1] = {};  ///< the first is 0
    int count = 0;              ///< of pieces
    double angle_rad = 0;       ///< largest angular deviation of the pieces

    [[nodiscard]] double most_off_m(int piece) const { return angle_rad * end[piece]; }
};

/// Divides rays up to a distance, or as far as kMax pieces reach. `angle_rad` is the allowed angular deviation; `stretch` is
/// the length of the longest direction per unit of t.
[[nodiscard]] PieceEnds cut_rays(const earth::Ecef& from, double angle_rad, double stretch, double far_m);

/// A line in grid space: origin + t * direction.
struct StraightPiece {
    glm::dvec3 origin{0}, direction{0};
};

/// Returns the piece from one distance to another; the first one (`from` 0) begins at the ray's origin.
[[nodiscard]] StraightPiece straight_piece(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction,
                                           double from, double to);

/// Allowed angular deviation of single rays of the world.
inline constexpr double kSingleOff_rad = 5e-5;

/// Traces a ray of grid space as the world ray that is tangent to it at its origin: `trace` receives the pieces as Rays, one
/// after another, and returns an object with `side` and `t`. It ends at 400 km, or where the ray has risen above `highest` for
/// good.
template <class Trace>
[[nodiscard]] auto trace_bent(const GroundSpace& space, const Ray& ray, double highest, const Trace& trace)
    -> decltype(trace(ray));

/// Returns a piece of a ray for trace_ray().
[[nodiscard]] Ray ray_of(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction, const PieceEnds& ends,
                         int piece);

template <class Trace>
auto trace_bent(const GroundSpace& space, const Ray& ray, double highest, const Trace& trace) -> decltype(trace(ray)) {
    constexpr double kFar_m = 400000, kSurelyRises = 1e-3;
    const WorldRay world = space.world_ray(ray.origin, glm::dvec3(ray.direction));
    const double from_m = static_cast<double>(ray.from) * world.metres_of_t,
                 to_m = static_cast<double>(ray.to) * world.metres_of_t;
    const PieceEnds ends = cut_rays(world.origin, kSingleOff_rad, 1, to_m < kFar_m ? to_m : kFar_m);
    auto hit = decltype(trace(ray)){};
    for (int n = 0; n < ends.count; ++n) {
        if (ends.end[n + 1] <= from_m) continue;
        Ray piece = ray_of(space, world.origin, world.direction, ends, n);
        if (ends.end[n] < from_m) piece.from = static_cast<float>(from_m);
        const double height = piece.origin.z + static_cast<double>(piece.direction.z) * static_cast<double>(piece.from);
        if (height > highest && static_cast<double>(piece.direction.z) * space.step_m() > kSurelyRises) break;
        hit = trace(piece);
        if (hit.side != HitSide::none) break;
    }
    hit.t = static_cast<decltype(hit.t)>(static_cast<double>(hit.t) / world.metres_of_t);
    return hit;
}

}  // namespace tedavis::raytrace
