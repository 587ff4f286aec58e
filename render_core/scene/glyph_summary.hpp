/// What a glyph stands for: one place with its value, or several together with what is common to them.
///
/// Means are those of the members that have a value; missing ones are counted, never averaged in. An uncertainty is the mean of
/// the members', rounded up, and unknown where one of them is. Plain data.
#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <type_traits>

#include "render_core/scene/uncertainty.hpp"
#include "render_core/scene/wind.hpp"

namespace tedavis::scene {

/// What the values of glyphs are.
enum class GlyphValues : std::uint8_t {
    wind,      ///< vectors towards east and north, m/s
    number,    ///< quantities, which have means
    category,  ///< numbers of classes, which have none
};

struct GlyphSummary {
    glm::vec3 place{0};    ///< mean of all members, the missing ones as well; m, in the frame of who gives it
    glm::vec3 reach_m{0};  ///< half the sides of a box round the place that holds the places of all members
    float value = 0;       ///< mean of the numbers, or towards east; the common class; 0 of none
    float north_mps = 0;   ///< of wind
    float speed_mps = 0;   ///< mean speed of wind, whatever its directions
    float size_m = 0;      ///< the largest member's, across its glyph
    float over_ground_m = std::numeric_limits<float>::quiet_NaN();  ///< mean of all members; NaN where one's is not known
    std::uint32_t members = 0;
    std::uint32_t missing = 0;  ///< of the members
    Uncertainty uncertainty;
    ValueState state = ValueState::missing;  ///< interpolated where one member is; missing where all are
    bool is_mixed = false;                   ///< classes differ: there is no common one
};
static_assert(std::is_trivially_copyable_v<GlyphSummary> && sizeof(GlyphSummary) == 56);

/// Of a sphere that holds the box.
[[nodiscard]] inline double radius_m(const GlyphSummary& summary) noexcept { return glm::length(glm::dvec3(summary.reach_m)); }

/// Of wind: calm, variable or unknown where no direction can be said.
[[nodiscard]] inline Wind wind_of(const GlyphSummary& summary) noexcept {
    if (summary.state == ValueState::missing) return {};
    return wind_of_means(summary.value, summary.north_mps, summary.speed_mps);
}

}  // namespace tedavis::scene
