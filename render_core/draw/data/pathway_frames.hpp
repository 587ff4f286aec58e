/// Decides where the frames of a pathway stand: rectangles across a planned path that the own ship is to fly through, 700 x 200
/// ft as in synthetic-vision displays in service.
///
/// Planned path   the line of the layer that passes nearest to the own ship, within kFarthestTrack_m (planned_track.hpp). Other
///                lines have no frames, and no line has any while the own ship's place is not valid.
/// Places         equal distances along the path from its end: kNearSpacing_m on the last kFinal_m, kSpacing_m before, so that a
///                frame keeps its place while the aircraft flies. Shown are those ahead of the own ship, at full detail the next
///                kMaxPathwayFrames.
/// Shape          upright and across the path, as wide as `size_m` states (kFrameWidth_m) and 2/7 as high.
/// Ground         within kFinal_m of the path's first or last place, no frame stands where the path is less than kLowest_m
///                above the ground, and so none on a runway. A frame whose middle is below the ground is left out; a lower edge
///                below the ground is raised to it.
/// Opacity        the farthest kFadingFrames fade in. Between kWhole_m and kGone_m ahead of the own ship frames fade out, so that
///                none flashes through the picture.
///
/// Pure, apart from queries to the ground. Bounded: the layer's points. Thread  the ground's.
#pragma once

#include <array>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/scene/feature_values.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMaxPathwayFrames = 6, kMinPathwayFrames = 3;
inline constexpr double kFrameWidth_m = 700 * base::kMetresPerFoot, kFrameHeightShare = 2.0 / 7;
inline constexpr double kSpacing_m = 0.5 * base::kMetresPerNauticalMile, kNearSpacing_m = kSpacing_m / 2;
inline constexpr double kFinal_m = 3 * base::kMetresPerNauticalMile;
inline constexpr double kLowest_m = 200 * base::kMetresPerFoot;
inline constexpr double kFadingFrames = 4;
inline constexpr double kGone_m = 100, kWhole_m = 250;

/// A layer's planned path.
struct Pathway {
    static constexpr std::uint32_t kNone = 0xFFFF'FFFF;
    std::uint32_t feature = kNone;  ///< kNone: the layer has none
    double length_m = 0;
    double own_m = 0;             ///< of the own ship's place along it
    glm::dvec3 begin{0}, end{0};  ///< ECEF
};
[[nodiscard]] Pathway planned_pathway(const ElementInput& input);

/// Returns the distance along the path at which frames begin to fade; a line continues from there.
[[nodiscard]] double faded_from_m(const ElementInput& input, const Pathway& pathway);

struct PathwayFrame {
    glm::dvec3 middle{0};        ///< ECEF
    glm::dvec3 right{0}, up{0};  ///< unit vectors: level and across the path; the vertical
    double half_width_m = 0, half_height_m = 0;
    double along_m = 0;             ///< from the path's begin
    double opacity = 1;             ///< 0..1
    scene::PointOfFeature point{};  ///< the layer's nearest, whose values it shows
};
using PathwayFrames = base::FixedVector<PathwayFrame, kMaxPathwayFrames>;

/// Returns the frames in the order of the path.
[[nodiscard]] PathwayFrames pathway_frames(const ElementInput& input, const Pathway& pathway);

/// Heights of a frame's lower edge relative to its middle, at the left, in the middle and at the right, m.
using LowerEdge = std::array<double, 3>;
[[nodiscard]] LowerEdge lower_edge(const ElementInput& input, const PathwayFrame& frame);

/// Returns the factor of the opacity at a distance ahead of the own ship: 0 up to kGone_m, 1 from kWhole_m on.
[[nodiscard]] double shown_ahead(double ahead_m);

}  // namespace tedavis::draw
