/// Decides which foci of a frame are magnified, and why the others are not.
///
/// Foci are magnified only on the map and in the orthographic view. The own ship's view must show everything at its true place:
/// its symbols are conformal, and a summit beside its true place is worse than none. For the same reason the own ship and half a
/// minute of its track are kept clear of everything that is moved: the ground below it and its distance to what is near are true
/// in every view. Magnification moves places horizontally only: heights, warning colours and the values of instruments never
/// change.
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
    egocentric,  ///< the view is the own ship's, or a transition from or to it
    no_terrain,
    no_place,     ///< the focus has no position in this frame
    not_one,      ///< the focus is not a single place
    too_narrow,   ///< its context leaves too little room
    no_position,  ///< the own ship's position is unknown, so it might be too close
    own_ship,     ///< the own ship or its track is too close
    overlaps,     ///< it would overlap another focus
    over_budget,  ///< the ground needs additional draws for its parts, and would be less accurate
};
/// Returns the reason as a part of a sentence, for records; "" where the focus is shown.
[[nodiscard]] const char* reason_of(DistortionState state) noexcept;

/// What a record says of one focus that the design requests to magnify.
struct DistortionRecord {
    base::FixedString<23> focus;
    DistortionState state = DistortionState::shown;
    std::uint32_t power = 0, compression = 0;  ///< powers of 2 that enlarge the focus and compress the ring; 0: not shown
    earth::Geodetic middle;                    ///< on the ground, where it is known; else on the ellipsoid
    bool is_square = false;
    double radius_m = 0, reach_m = 0;  ///< nothing moves beyond reach_m; 0: not shown
};
using DistortionRecords = base::FixedVector<DistortionRecord, scene::kMaxFoci>;

struct DistortionScene {
    const design::FocusList& foci;
    base::Span<const scene::FocusRegion> regions;  ///< of each focus
    bool is_far = false;                           ///< the map or the orthographic view, not during a transition
    bool shows_terrain = false;
    bool has_position = false;  ///< of the own ship, valid
    earth::Ecef own_ship{0};
    double ground_speed_mps = 0;  ///< NaN where it is not known
};

/// Radius kept clear round the own ship: at least kMinClear_m, else the distance flown in kClear_s; with unknown speed that at
/// kUnknownSpeed_mps.
inline constexpr double kMinClear_m = 2000, kClear_s = 30, kUnknownSpeed_mps = 250;

struct DistortionPlan {
    earth::Magnifiers magnifiers;
    DistortionRecords records;
};
/// Plans the foci in the order of the design: of two that would overlap the first is magnified.
[[nodiscard]] DistortionPlan plan_distortion(const DistortionScene& scene) noexcept;
/// Withdraws all foci that would be shown, for this reason.
void withhold(DistortionRecords& records, DistortionState reason) noexcept;

}  // namespace tedavis::display
