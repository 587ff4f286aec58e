#include "render_core/raytrace/space/straight_pieces.hpp"

#include <cmath>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::raytrace {
namespace {

/// Nodes of Chebyshev on 0..1.
constexpr double kEarly = 0.14644660940672624, kLate = 0.85355339059327376;

/// 1/m: by how much rays bend at a place, at most. Vertically they do by 1/R, and where they run down while they run out, aside
/// by as much; in the lattice great circles bend by tan(latitude)/R, and twice where they cross it aslant.
double most_bend(double latitude_rad) { return (1.15 + 0.85 * std::abs(std::tan(latitude_rad))) / earth::kMinCurvatureRadius_m; }

}  // namespace

PieceEnds cut_rays(const earth::Ecef& from, double angle_rad, double stretch, double far_m) {
    PieceEnds ends;
    ends.angle_rad = angle_rad;
    const double bend = most_bend(earth::from_ecef(from).latitude_rad) * stretch * stretch;
    // The first: its line begins at the origin, off by angle t |t - s/2| bend / 2.
    double end = 4 * angle_rad / bend;
    while (ends.count < PieceEnds::kMax) {
        ends.end[++ends.count] = end < far_m ? end : far_m;
        if (end >= far_m) break;
        end += std::sqrt(16 * angle_rad * end / bend);
    }
    return ends;
}

StraightPiece straight_piece(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction, double from,
                             double to) {
    StraightPiece piece;
    if (from == 0) {
        const double middle = 0.5 * to;
        piece.origin = space.place(origin);
        piece.direction = (space.place(origin + middle * direction) - piece.origin) / middle;
        return piece;
    }
    const double early = from + kEarly * (to - from), late = from + kLate * (to - from);
    const glm::dvec3 first = space.place(origin + early * direction), second = space.place(origin + late * direction);
    piece.direction = (second - first) / (late - early);
    piece.origin = first - early * piece.direction;
    return piece;
}

Ray ray_of(const GroundSpace& space, const earth::Ecef& origin, const glm::dvec3& direction, const PieceEnds& ends, int piece) {
    const StraightPiece line = straight_piece(space, origin, direction, ends.end[piece], ends.end[piece + 1]);
    Ray ray;
    ray.origin = line.origin;
    ray.direction = glm::vec3(line.direction);
    ray.from = static_cast<float>(ends.end[piece]);
    ray.to = static_cast<float>(ends.end[piece + 1]);
    ray.gap = static_cast<float>(2 * ends.most_off_m(piece) / space.step_m());
    return ray;
}

}  // namespace tedavis::raytrace
