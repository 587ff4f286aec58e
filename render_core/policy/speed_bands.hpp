/// The bands and flags of the airspeed tape, by the aircraft file (design/aircraft_settings.hpp) and what is known of the flaps
/// and of the load factor. Pure function; any thread.
///
/// There are two columns. Where the limit is known the first reaches from 0 to kEndOfBands_mps without gaps and overlaps:
/// low-speed warning, low-speed caution, normal, caution, above the limit, of which bands without extent are left out. The second
/// has one band, the range in which all flaps may be out, from the stall speed with them to their limit. Colours have the meaning
/// that they have on mechanical airspeed indicators (FAA-H-8083-25, Pilot's Handbook of Aeronautical Knowledge, airspeed
/// indicator markings).
///
/// Where the position of the flaps is not known exactly, the limit is that of the flaps that may be farthest out, and the stall
/// speed that of those that may be least far out; between two settings the stricter one holds. So a wider range never raises the
/// limit and never lowers the stall speed. The stall speed grows with the root of the load factor. The mass is not known: the
/// greatest mass, which the file states, is assumed.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/aircraft_settings.hpp"

namespace tedavis::policy {

enum class SpeedBandRole : std::uint8_t {
    low_warning,  ///< (red) below the stall speed
    low_caution,  ///< (amber) up to the stall speed times the file's caution_factor
    normal,       ///< (green)
    caution,      ///< (yellow) above Vno: in smooth air only
    above_limit,  ///< (red, or a pole in red and white) above Vne, Vmo or the limit of the flaps
    flaps_range,  ///< (white) all flaps may be out; a column of its own
};
inline constexpr std::size_t kSpeedBandRoles = 6;

/// The end of the first column, above all speeds of aircraft files.
inline constexpr double kEndOfBands_mps = 400;
/// Greater load factors count as this one.
inline constexpr double kMaxLoadFactor = 4;

struct SpeedBand {
    double low_mps = 0, high_mps = 0;  ///< calibrated airspeed, low < high
    SpeedBandRole role = SpeedBandRole::normal;
};

/// Positions that the flaps may have, as fractions of full travel: 0 <= least <= most <= 1. Both are equal where the position is
/// known; anything else than such a range means that nothing is known.
struct FlapsRange {
    double least = 0, most = 1;
};

/// What is known of the flight.
struct SpeedConditions {
    FlapsRange flaps;
    double load_factor = 1;  ///< normal acceleration in units of standard gravity; counts from 1 to kMaxLoadFactor
    double pressure_altitude_m = std::numeric_limits<double>::quiet_NaN();  ///< NaN where it is not known
    bool is_on_ground = false;                                              ///< no low-speed warning and caution then
};

struct SpeedBands {
    base::FixedVector<SpeedBand, kSpeedBandRoles> bands;  ///< by rising speed; flaps_range comes last
    base::FixedVector<design::SpeedFlag, design::kMaxSpeedFlags> flags;
    bool has_pole = false;  ///< above_limit is a pole in red and white
};
static_assert(std::is_trivially_copyable_v<SpeedBands>);

/// Returns the bands and flags; none without an aircraft file. At an altitude at which the file's limit may not hold, or at an
/// unknown altitude, it returns only flags, low-speed warning and low-speed caution.
[[nodiscard]] SpeedBands speed_bands(const design::AircraftSettings& aircraft, const SpeedConditions& conditions) noexcept;

}  // namespace tedavis::policy
