/// Makes the rings of a tube round a trajectory from its recorded points.
///
/// Errors of a recording are removed and counted: points too close to the one before are dropped; points that are not finite,
/// and time that runs back, end a piece of the tube. Where the path turns back on itself (a cusp) the piece ends too, and the
/// next one begins there with the same normal. A single point is a marker. Frames are rotation-minimising along a piece
/// (tube_frame.hpp) and begin with the normal upwards.
///
/// Metres; axes are chosen by the caller, Earth-centred or local. Memory  the caller's spans. Bounded: each point is visited
/// once. Pure; any thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"
#include "render_core/base/time.hpp"
#include "render_core/scene/tube_frame.hpp"

namespace tedavis::scene {

/// Points nearer to the one before than the larger of these are dropped; the second is multiplied by the distance from the
/// origin.
inline constexpr double kMinTubeStep_m = 1e-3, kMinTubeStepOfDistance = 1e-7;
/// Cosine of the change of direction beyond which a tube is split.
inline constexpr double kCuspCosine = -0.999;
/// Points farther from the origin than this count as missing.
inline constexpr double kFarthestTubePoint_m = 1e12;

struct TubePoint {
    glm::dvec3 position{0};
    base::Time time;     ///< may be equal to the one before, as stamps in whole seconds can be
    float radius_m = 1;  ///< greater than 0
};

struct TubeRing {
    glm::dvec3 centre{0};
    TubeFrame frame;  ///< its tangent is that of the circle through the previous, this and the next point
    float radius_m = 0;
    std::uint32_t source = 0;  ///< index of the point
    std::uint32_t piece = 0;   ///< counts from 0; rings of a piece are consecutive, at least two unless it is a marker
    bool is_marker = false;    ///< the piece is a single point
    bool folds = false;        ///< the path's radius of curvature is below the tube's radius: the tube intersects itself
};

struct TubeCounts {
    std::uint32_t rings = 0;
    std::uint32_t pieces = 0;  ///< markers included
    std::uint32_t markers = 0;
    std::uint32_t close_points = 0;    ///< dropped
    std::uint32_t missing_points = 0;  ///< position or radius not finite or out of range
    std::uint32_t times_back = 0;      ///< points earlier than the one before
    std::uint32_t cusps = 0;
    std::uint32_t folds = 0;
    std::uint32_t points_left_out = 0;  ///< points after the last ring, for which there was no room
};

/// `up` is the direction of a piece's first normal, of any length; zero means away from the origin, as for Earth-centred
/// positions. `rings` needs one per point and one more per cusp; the tube ends where they are used up.
[[nodiscard]] TubeCounts make_tube(base::Span<const TubePoint> points, const glm::dvec3& up, base::Span<TubeRing> rings) noexcept;

}  // namespace tedavis::scene
