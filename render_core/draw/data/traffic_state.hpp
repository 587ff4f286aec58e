/// Where another aircraft is, from its reports. Pure function; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/flight/traffic.hpp"

namespace tedavis::draw {

/// Between reports farther apart nothing is interpolated: it may have gone anywhere.
inline constexpr double kLongestReportGap_s = flight::kTrafficGap.to_seconds();
/// So long it is taken to go on as it did; then it stands there, stale, and after the second it is gone.
inline constexpr double kExtrapolated_s = 10, kRemoved_s = flight::kTrafficKept.to_seconds();
/// How much less sure its place grows (95 %) with the age t of its report, beyond the accuracy that was stated: level by
/// kManoeuvre_mps2 t^2 / 2 while it is taken to go on, and then as fast as it may go by then, its speed and what it may have
/// gained together; upright in the same way by kClimbing_mps2. Where no two reports tell its speed, it stands there and may go at
/// kAnySpeed_mps and kAnyClimb_mps.
inline constexpr double kManoeuvre_mps2 = 3, kClimbing_mps2 = 1;
inline constexpr double kAnySpeed_mps = 250, kAnyClimb_mps = 20;

struct TrafficState {
    scene::ScenePoint point{};           ///< height in the layer's datum
    double east = 0, north = 0, up = 0;  ///< m/s
    double age_s = 0;                    ///< since the last report that is used; 0 between two; NaN: nobody knows
    PlaceAccuracy accuracy;              ///< by now; 0: nobody knows
    bool is_known = false;               ///< false: none yet, none for kRemoved_s, or no reports
    bool is_stale = false;               ///< older than kExtrapolated_s, or of unknown age
    bool has_velocity = false;           ///< two reports give one
};

/// At the frame's time; without a date, at its last report. Reports without times have no age and no velocity.
[[nodiscard]] TrafficState traffic_state(const ElementInput& input, std::uint32_t feature);

}  // namespace tedavis::draw
