/// Warning bands: colours of terrain by its height relative to the aircraft, for terrain awareness; not a terrain alerting
/// system.
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

/// Ground of which the display warns, and for which it cautions; the same by day and by night, as all of the ground.
inline constexpr Color kWarningGround{0xE0, 0x10, 0x10}, kCautionGround{0xF0, 0xD0, 0x00};

/// A band of terrain at or above `lower_m` (terrain minus aircraft height, m), up to the band before it.
struct WarningBand {
    double lower_m = 0;
    double lower_gear_down_m = 0;  ///< the same limit with the gear down
    Color color;
    double strength = 0;  ///< 0..1, opacity of the colour over the terrain's; used for two densities of a hue
};
using WarningBands = base::FixedVector<WarningBand, kMaxWarningBands>;

[[nodiscard]] WarningBands egpws_bands() noexcept;
[[nodiscard]] WarningBands garmin_bands() noexcept;

/// Returns the index of the first band whose limits do not lie below those of the band before it; bands.size() when all are in
/// order.
[[nodiscard]] std::size_t first_band_out_of_order(const WarningBands& bands) noexcept;

/// Returns the index of the band for terrain above (+) or below (-) the aircraft; bands.size() for none.
[[nodiscard]] std::size_t band_of(const WarningBands& bands, double terrain_above_aircraft_m, bool gear_down) noexcept;

}  // namespace tedavis::design
