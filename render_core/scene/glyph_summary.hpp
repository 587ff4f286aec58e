/// What a glyph stands for: one site with its value, or several sites with a summary of their values.
///
/// Means are over the members that have a value; missing ones are only counted. The uncertainty is the mean of the members',
/// rounded up; it is unknown where that of one member is unknown. Plain data.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>

#include "render_core/scene/uncertainty.hpp"
#include "render_core/scene/wind.hpp"

namespace tedavis::scene {

/// The kind of values of glyphs.
enum class GlyphValues : std::uint8_t {
    wind,      ///< vectors towards east and north, m/s
    number,    ///< quantities, which have means
    category,  ///< class numbers, which have no means
};

struct GlyphSummary {
    glm::vec3 place{0};    ///< mean of all members, missing ones included; m, in the frame of its source
    glm::vec3 reach_m{0};  ///< half the sides of a box round `place` that contains all members
    float value = 0;       ///< number: the mean; wind: towards east; category: the common class; 0 where there is none
    float north_mps = 0;   ///< of wind
    float speed_mps = 0;   ///< wind: mean speed, regardless of direction
    float size_m = 0;      ///< size across the largest member's glyph
    float over_ground_m = std::numeric_limits<float>::quiet_NaN();  ///< mean of all members; NaN where one is unknown
    std::uint32_t members = 0;
    std::uint32_t missing = 0;  ///< of the members
    Uncertainty uncertainty;
    ValueState state = ValueState::missing;  ///< interpolated where any member is; missing where all are
    bool is_mixed = false;                   ///< the members' classes differ
};
static_assert(std::is_trivially_copyable_v<GlyphSummary> && sizeof(GlyphSummary) == 56);

/// Radius of a sphere that contains the box.
[[nodiscard]] inline double radius_m(const GlyphSummary& summary) noexcept { return glm::length(glm::dvec3(summary.reach_m)); }

/// Returns the wind of a summary; calm, variable or unknown where it has no direction.
[[nodiscard]] inline Wind wind_of(const GlyphSummary& summary) noexcept {
    if (summary.state == ValueState::missing) return {};
    return wind_of_means(summary.value, summary.north_mps, summary.speed_mps);
}

}  // namespace tedavis::scene
