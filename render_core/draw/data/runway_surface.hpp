/// The plane of a runway on the drawn ground: a chain of level cross-sections from its first point to its last one.
///
/// A section lies kRunwayLift_m above the highest of the drawn ground below its middle and its two edges, so that every corner
/// lies on the drawn ground at every level of detail; where the ground is unknown, at the height that the data state. Sections
/// are as far apart as the distance of the eye allows. Between sections, and beyond the ends, places lie on straight lines.
///
/// Pure, apart from queries to the ground. Bounded: kMaxRunwaySections, three queries each.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kRunwayLift_m = 0.3;
inline constexpr std::size_t kMaxRunwaySections = 162;
inline constexpr double kMinRunway_m = 120, kMaxRunway_m = 8000;

class RunwaySurface {
public:
    /// Builds the plane. Returns false where the length is not kMinRunway_m..kMaxRunway_m, or the height is unknown.
    [[nodiscard]] bool build(const ElementInput& input, const scene::ScenePoint& first, const scene::ScenePoint& last,
                             double width_m);

    [[nodiscard]] double length_m() const { return length_m_; }
    [[nodiscard]] double half_width_m() const { return half_m_; }
    [[nodiscard]] double bearing_rad() const;                     ///< true, from the first point to the last one
    [[nodiscard]] const glm::dvec2& way() const { return way_; }  ///< unit vector east, north
    [[nodiscard]] std::size_t sections() const { return middles_.size(); }
    [[nodiscard]] double along_m(std::size_t section) const { return step_m_ * static_cast<double>(section); }
    [[nodiscard]] const glm::dvec3& up() const { return up_; }
    [[nodiscard]] const glm::dvec3& right() const { return right_; }
    [[nodiscard]] glm::dvec3 at(double along_m, double aside_m) const;  ///< ECEF

private:
    [[nodiscard]] double step_from(const ElementInput& input, const glm::dvec3& middle) const;

    base::FixedVector<glm::dvec3, kMaxRunwaySections> middles_;
    glm::dvec2 way_{0};
    glm::dvec3 up_{0}, right_{0};
    double length_m_ = 0, half_m_ = 0, step_m_ = 0;
};

/// Height above the ellipsoid of the drawn ground at a place, else of what the data state; NaN where nothing is known.
[[nodiscard]] double seat_height_m(const ElementInput& input, const scene::ScenePoint& place);

}  // namespace tedavis::draw
