/// Colours of terrain by its height relative to the aircraft: awareness, no terrain alerting system.
///
/// Two profiles are built in: `egpws` (Honeywell EGPWS plan view: 965-1176-601 table 6.7-1, MK VI/VIII pilot guide
/// 060-4314-000) and `garmin` (100/1000 ft; FAA Advanced Avionics Handbook chapter 5). They are meaningful only for a
/// geometric height of the aircraft; the failure policy removes them otherwise.
#pragma once

#include <cstddef>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxWarningBands = 8;

/// Terrain at or above `lower_m` (terrain minus aircraft height, metres), up to the band before it.
struct WarningBand {
    double lower_m = 0;
    double lower_gear_down_m = 0;  ///< the same limit with the gear down
    Color color;
    double strength = 0;  ///< 0..1 of the colour over the terrain's own; the two densities of a hue
};
using WarningBands = base::FixedVector<WarningBand, kMaxWarningBands>;

[[nodiscard]] WarningBands egpws_bands() noexcept;
[[nodiscard]] WarningBands garmin_bands() noexcept;

/// Index of the first band whose limits do not lie below those of the band before it; bands.size() when all is in order.
[[nodiscard]] std::size_t first_band_out_of_order(const WarningBands& bands) noexcept;

/// Index of the band of terrain so far above (+) or below (-) the aircraft; bands.size() for none.
[[nodiscard]] std::size_t band_of(const WarningBands& bands, double terrain_above_aircraft_m, bool gear_down) noexcept;

/// Whether they color ground as high as the aircraft, so that it can be told from the rest.
[[nodiscard]] bool warn_of_ground_ahead(const WarningBands& bands) noexcept;

}  // namespace tedavis::design
