/// Which foci of a frame are shown larger than what is round them, and which are not, and why.
///
/// Only seen from far away: on the map and in the orthographic view. What the own ship sees ahead must lie where it is: symbols
/// over it are conformal, and a summit beside its true place is worse than none. So, too, the own ship and half a minute of its
/// way stay clear of all that is moved: its distance to what is near it, and the ground below it, are true in every view. Of the
/// rest of the picture only the plane is moved: heights, warning colours, and what instruments say are never.
///
/// Pure; any thread.
#pragma once

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/span.hpp"
#include "render_core/design/focus_settings.hpp"
#include "render_core/earth/magnifier.hpp"
#include "render_core/scene/focus_region.hpp"

namespace tedavis::display {

enum class DistortionState : std::uint8_t {
    shown,
    egocentric,  ///< the view is the own ship's, or on the way from or to it
    no_terrain,
    no_place,     ///< the focus is nowhere in this frame
    not_one,      ///< it is no single place
    too_narrow,   ///< its context leaves too little room
    no_position,  ///< of the own ship, so that nobody knows whether it is clear
    own_ship,     ///< it is not
    overlaps,     ///< another one
    over_budget,  ///< the ground takes a draw more for each of its parts, and would be less accurate for it
};
/// A sentence's part for records; "" where it is shown.
[[nodiscard]] const char* reason_of(DistortionState state) noexcept;

/// Of one focus that the design asks to be larger.
struct DistortionRecord {
    base::FixedString<23> focus;
    DistortionState state = DistortionState::shown;
    std::uint32_t power = 0, compression = 0;  ///< of two: the focus is so much larger, the ring so much smaller; 0: not shown
    earth::Geodetic middle;                    ///< on the ground, where it is known; else on the ellipsoid
    bool is_square = false;
    double radius_m = 0, reach_m = 0;  ///< beyond the latter nothing moves; 0: not shown
};
using DistortionRecords = base::FixedVector<DistortionRecord, scene::kMaxFoci>;

struct DistortionScene {
    const design::FocusList& foci;
    base::Span<const scene::FocusRegion> regions;  ///< of each focus
    bool is_far = false;                           ///< the map or the orthographic view, arrived at
    bool shows_terrain = false;
    bool has_position = false;  ///< of the own ship, valid
    earth::Ecef own_ship{0};
    double ground_speed_mps = 0;  ///< NaN where it is not known
};

/// Of the own ship at least, and half a minute of its way; of one whose speed nobody knows that of a fast one.
inline constexpr double kMinClear_m = 2000, kClear_s = 30, kUnknownSpeed_mps = 250;

struct DistortionPlan {
    earth::Magnifiers magnifiers;
    DistortionRecords records;
};
/// In the order of the design: the first of two that would overlap is shown.
[[nodiscard]] DistortionPlan plan_distortion(const DistortionScene& scene) noexcept;
/// What is shown is not, after all.
void withhold(DistortionRecords& records, DistortionState reason) noexcept;

}  // namespace tedavis::display
