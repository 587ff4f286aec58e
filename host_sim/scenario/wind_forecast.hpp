/// A generated forecast of the wind round the strip: the layer "wind", for the start and the two hours after it.
///
/// At the strip, kWindReference_m above it, it is the flight's own wind. With the height h above the strip the speed is
/// proportional to (h / kWindReference_m)^(1/7), the power law of a neutral boundary layer, and the direction turns as in Ekman's
/// spiral, by kVeer_rad (exp(-kWindReference_m / kVeerHeight_m) - exp(-h / kVeerHeight_m)), to the right in the north and to the
/// left in the south. Away from the strip, smooth random variations are added to both components, scaled by 1 - exp(-(d /
/// kStationReach_m)^2) at the distance d; they drift with the wind. The uncertainty grows with distance and time:
///     sigma = wind_sigma_mps (1 + d / kSigmaDistance_m + t / 1 h)
/// The attributes are "east", "north" and "speed" (m/s), with standard deviations, of which kFullWindSigma_mps is level 1.
#pragma once

#include <array>

#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/scene_builder/scene_draft.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

inline constexpr std::uint32_t kWindPosts = 20;
inline constexpr std::array<double, 5> kWindHeights_m = {2, 300, 800, 1600, 3000};  ///< above the strip
inline constexpr int kWindTimes = 3;                                                ///< an hour apart
inline constexpr double kWindReference_m = 300;
inline constexpr double kVeer_rad = base::radians(25), kVeerHeight_m = 1000;
inline constexpr double kStationReach_m = 8'000, kSigmaDistance_m = 15'000;
inline constexpr double kFullWindSigma_mps = 4;

/// The wind vector (direction in which it blows) at a height above the strip, m/s.
struct MeanWind {
    double east_mps = 0, north_mps = 0;
};
[[nodiscard]] MeanWind mean_wind(const FlownAir& air, double strip_latitude_rad, double height_m);

/// The scenario must have weather.
[[nodiscard]] LayerDraft make_wind_layer(const Scenario& scenario, const FlownAir& air, SeededRandom& random);

}  // namespace tedavis::host_sim
