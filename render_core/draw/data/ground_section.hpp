/// Cross-sections of a strip on the ground, and the strip's direction in metres east and north.
///
/// A section is level, kStripLift_m above the highest ground below it, because terrain is drawn with a tolerance; where the
/// ground is unknown it has the height of its point. Pure, apart from queries to the ground.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kLongestStep_m = 200;  ///< from section to section
inline constexpr double kStripLift_m = 1.0;
inline constexpr float kStripRaised_px = 2.5f;  ///< the drawn ground deviates from the true one by about a pixel

/// Metres east and north from one point to another; the point at such an offset; and a point between two.
[[nodiscard]] glm::dvec2 flat_offset(const scene::ScenePoint& from, const scene::ScenePoint& to);
[[nodiscard]] scene::ScenePoint moved(const scene::ScenePoint& from, const glm::dvec2& by_m);
[[nodiscard]] scene::ScenePoint between(const scene::ScenePoint& from, const scene::ScenePoint& to, double share);
/// The right end of a section of unit half width, for a direction east and north; 0 for no direction.
[[nodiscard]] glm::dvec2 right_of(const glm::dvec2& way);

struct GroundSection {
    scene::ScenePoint middle{};
    glm::dvec2 half{0};  ///< metres east and north to its right end
    double height_m = 0;
    bool is_known = false;

    [[nodiscard]] glm::dvec3 at(double share, double down_m = 0) const;
};
[[nodiscard]] GroundSection ground_section(const ElementInput& input, const scene::ScenePoint& middle, const glm::dvec2& half);

/// A section's ends. Normals lean outwards, so that raising the strip in pixels also widens it and it is never too narrow to be
/// visible.
struct SectionEnds {
    glm::dvec3 left{0}, right{0}, left_normal{0}, right_normal{0};
};
[[nodiscard]] SectionEnds section_ends(const GroundSection& at);

}  // namespace tedavis::draw
