/// Cross-sections of a strip that lies on the ground, such as a runway or a road, and offsets on the ground in metres east and
/// north.
///
/// A section is level. It lies kStripLift_m above the highest ground below it, because terrain is drawn with a tolerance; where
/// the ground is unknown, it has the height that the data state for its middle. Pure, apart from queries to the ground.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kLongestStep_m = 200;  ///< largest distance between neighbouring sections
inline constexpr double kStripLift_m = 1.0;
inline constexpr float kStripRaised_px = 2.5f;  ///< the drawn ground deviates from the true one by about a pixel

/// Returns the offset between two points, metres east and north, by the radii of curvature at `from`.
[[nodiscard]] glm::dvec2 flat_offset(const scene::ScenePoint& from, const scene::ScenePoint& to);
/// Returns the point at such an offset.
[[nodiscard]] scene::ScenePoint moved(const scene::ScenePoint& from, const glm::dvec2& by_m);
/// Returns the point at a share, 0..1, of the way.
[[nodiscard]] scene::ScenePoint between(const scene::ScenePoint& from, const scene::ScenePoint& to, double share);
/// Returns the unit vector to the right of a direction; both have components east and north. 0 where `way` is 0.
[[nodiscard]] glm::dvec2 right_of(const glm::dvec2& way);

struct GroundSection {
    scene::ScenePoint middle{};
    glm::dvec2 half{0};  ///< from the middle to the right end, metres east and north
    double height_m = 0;
    bool is_known = false;

    [[nodiscard]] glm::dvec3 at(double share, double down_m = 0) const;
};
[[nodiscard]] GroundSection ground_section(const ElementInput& input, const scene::ScenePoint& middle, const glm::dvec2& half);

/// The two ends of a section with their normals. The shader raises a strip along its normals by kStripRaised_px. Normals lean
/// outwards, so that this also widens the strip, which is then never too narrow to be visible.
struct SectionEnds {
    glm::dvec3 left{0}, right{0}, left_normal{0}, right_normal{0};
};
[[nodiscard]] SectionEnds section_ends(const GroundSection& at);

}  // namespace tedavis::draw
