/// The rings of a tube round a trajectory, from its recorded points.
///
/// What a recording has wrong is taken out and counted: points too close to the one before are dropped; points that are not
/// finite, and time that runs back, end a piece of tube. Where the way turns back on itself the piece ends too, and the next one
/// begins there with the same normal. A single point is a marker; no points are nothing. Frames turn as little as possible along
/// a piece (tube_frame.hpp), and begin with the normal upwards.
///
/// Metres; axes are the caller's, Earth-centred or local. Memory  the caller's spans. Bounded: one visit a point. Pure; any
/// thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"
#include "render_core/base/time.hpp"
#include "render_core/scene/tube_frame.hpp"

namespace tedavis::scene {

/// Points nearer than the larger of these to the one before are dropped; the second is times the distance from the origin.
inline constexpr double kMinTubeStep_m = 1e-3, kMinTubeStepOfDistance = 1e-7;
/// Cosine of the turn beyond which a tube is split.
inline constexpr double kCuspCosine = -0.999;
/// Farther from the origin is not taken for a place.
inline constexpr double kFarthestTubePoint_m = 1e12;

struct TubePoint {
    glm::dvec3 position{0};
    base::Time time;     ///< may stand still, as stamps of whole seconds do
    float radius_m = 1;  ///< greater than 0
};

struct TubeRing {
    glm::dvec3 centre{0};
    TubeFrame frame;  ///< tangent: of the circle through the points before, here and after
    float radius_m = 0;
    std::uint32_t source = 0;  ///< which of the points
    std::uint32_t piece = 0;   ///< counts from 0; rings of a piece lie side by side, two at least unless it is a marker
    bool is_marker = false;    ///< a piece of a single point
    bool folds = false;        ///< the way bends more tightly than the tube is wide: it passes through itself
};

struct TubeCounts {
    std::uint32_t rings = 0;
    std::uint32_t pieces = 0;  ///< markers included
    std::uint32_t markers = 0;
    std::uint32_t close_points = 0;    ///< dropped
    std::uint32_t missing_points = 0;  ///< place or radius not finite, or outside its range
    std::uint32_t times_back = 0;      ///< points earlier than the one before
    std::uint32_t cusps = 0;
    std::uint32_t folds = 0;
    std::uint32_t points_left_out = 0;  ///< behind the last ring, for want of room
};

/// `up`: where the first normal of a piece points to, of any length; zero: away from the origin, as Earth-centred places want it.
/// `rings` needs one a point, and one more a cusp; the tube ends where they do.
[[nodiscard]] TubeCounts make_tube(base::Span<const TubePoint> points, const glm::dvec3& up, base::Span<TubeRing> rings) noexcept;

}  // namespace tedavis::scene
