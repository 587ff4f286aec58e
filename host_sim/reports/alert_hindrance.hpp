/// Why no terrain alert could be given in a frame, by its record.
///
/// Where the aircraft stands, taxis or lands, the alert's rules inhibit it; this is no hindrance.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

enum class AlertHindrance : std::uint8_t {
    none,  ///< an alert was possible
    no_terrain,
    terrain_failed,
    no_position,
    outside,         ///< of the terrain database
    below_surface,   ///< of the terrain database
    degraded,        ///< position or height are not reliable
    unknown_ground,  ///< the ground below has no height
    count_
};
inline constexpr std::size_t kAlertHindranceCount = static_cast<std::size_t>(AlertHindrance::count_);

/// Returns the first hindrance that applies, in the order above; none where the frame has an alert.
[[nodiscard]] AlertHindrance hindrance_of(const display::FrameRecord& record);
/// "outside", as in summary.json.
[[nodiscard]] const char* name_of(AlertHindrance hindrance);
/// A main clause: "the aircraft was outside the terrain database".
[[nodiscard]] const char* words_of(AlertHindrance hindrance);

}  // namespace tedavis::host_sim
