/// The estimated state of another aircraft, from its reports. Pure function; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/flight/traffic.hpp"

namespace tedavis::draw {

/// Positions are not interpolated between reports farther apart than this.
inline constexpr double kLongestReportGap_s = flight::kTrafficGap.to_seconds();
/// Time for which its position is extrapolated; then it is held and stale, and removed after kRemoved_s.
inline constexpr double kExtrapolated_s = 10, kRemoved_s = flight::kTrafficKept.to_seconds();
/// Growth of the position uncertainty (95 %) with the age t of the report, added to the stated accuracy: horizontally
/// kManoeuvre_mps2 t^2 / 2 while it is extrapolated, and then at its speed plus the speed that it may have gained; vertically
/// in the same way with kClimbing_mps2. Where no two reports give its speed, it is held and the uncertainty grows at
/// kAnySpeed_mps and kAnyClimb_mps.
inline constexpr double kManoeuvre_mps2 = 3, kClimbing_mps2 = 1;
inline constexpr double kAnySpeed_mps = 250, kAnyClimb_mps = 20;

struct TrafficState {
    scene::ScenePoint point{};           ///< height in the layer's datum
    double east = 0, north = 0, up = 0;  ///< m/s
    double age_s = 0;                    ///< since the last report used; 0 between two reports; NaN: unknown
    PlaceAccuracy accuracy;              ///< current accuracy; 0: unknown
    bool is_known = false;               ///< false: none yet, none for kRemoved_s, or no reports
    bool is_stale = false;               ///< older than kExtrapolated_s, or of unknown age
    bool has_velocity = false;           ///< two reports give one
};

/// Other aircraft are proximate within these of the own ship: the first step of a TCAS II display (FAA, Introduction to TCAS II
/// Version 7.1, 2011). The next steps of such a display are advisories, which only a TCAS
/// may issue; there are none here.
inline constexpr double kProximate_m = 6 * 1852.0, kProximateHeight_m = 1200 * 0.3048;
/// True for a proximate aircraft. False where its report is stale, its height unknown, or the own ship's position not valid.
/// `height_m` above the ellipsoid.
[[nodiscard]] bool is_proximate(const ElementInput& input, const TrafficState& state, double height_m);

/// Returns the state at the frame's time; without a date, at its last report. Reports without times have neither age nor
/// velocity.
[[nodiscard]] TrafficState traffic_state(const ElementInput& input, std::uint32_t feature);

}  // namespace tedavis::draw
