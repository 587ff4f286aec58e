/// An aircraft file (configs/aircraft/*.toml): what the display must know of the aircraft that it is built into. Its speeds mark
/// the airspeed tape (policy/speed_bands.hpp), and the camera stands at its eye point.
///
/// Plain data in SI units and radians. Speeds are calibrated airspeeds at the greatest mass, in level flight; files state them in
/// knots or metres per second, with the unit in the key, and the reader is the only place that converts them.
/// Memory   reading allocates (start-up only). Failure  one sentence with file and line.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>
#include <type_traits>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/units.hpp"
#include "render_core/flight/motion_phase_settings.hpp"

namespace tedavis::design {

/// Range of all speeds of a file.
inline constexpr double kMinAircraftSpeed_mps = 5, kMaxAircraftSpeed_mps = 350;
/// Settings of the flaps are so far apart, as a fraction of full travel; policy/speed_bands.hpp tells them apart by it.
inline constexpr double kMinFlapStep = 0.05;
inline constexpr std::size_t kMaxFlapSettings = 8, kMaxSpeedFlags = 10;

/// A setting of the flaps.
struct FlapSetting {
    base::FixedString<7> name;  ///< as the pilot calls it: "UP", "10", "FULL"
    double position = 0;        ///< 0 .. 1, fraction of full travel
    double limit_mps = 0;       ///< highest speed with it (Vfe); with the flaps at 0, that of the aircraft
    double stall_mps = 0;       ///< stall speed with it (Vs1 with the flaps at 0, Vs0 with all of them)
};

/// A speed that a flag marks on the tape.
struct SpeedFlag {
    base::FixedString<2> name;  ///< one or two upper-case letters or digits: "R", "V2"
    double speed_mps = 0;       ///< at most that of the limit
};

/// The pilot's eye point in body axes, from the antenna that the position is of.
struct EyePoint {
    double forward_m = 0, right_m = 0, up_m = 0;  ///< -100 .. 100
};

struct AircraftSettings {
    base::FixedString<31> name;                                              ///< empty: there is no aircraft file
    flight::AircraftClass aircraft_class = flight::AircraftClass::unstated;  ///< by which its motion tells the flight phase
    double normal_limit_mps = 0;  ///< Vno: above it in smooth air only; 0: there is none
    double limit_mps = 0;         ///< Vne, or Vmo
    bool has_vmo = false;         ///< the limit is a maximum operating speed, which a pole in red and white marks
    /// Pressure altitude up to which Vmo is the limit, as above it a Mach number is, which the display does not know.
    double limit_up_to_m = std::numeric_limits<double>::infinity();
    /// By rising position, the first at 0 and, where there are several, the last at 1. Limits and stall speeds never rise. A
    /// helicopter has one with a stall speed of 0.
    base::FixedVector<FlapSetting, kMaxFlapSettings> flaps;
    base::FixedVector<SpeedFlag, kMaxSpeedFlags> flags;
    double caution_factor = 1.1;  ///< (1.01 .. 1.5) the low-speed cue is amber up to so many times the stall speed
    EyePoint eye;
    double excessive_bank_rad = base::radians(45);  ///< (10 .. 85 degrees)
    double standard_turn_rad_s = base::radians(3);  ///< (0.5 .. 6 degrees a second) rate of a standard-rate turn

    /// False without an aircraft file: then no speed is known, and the eye point is the antenna.
    [[nodiscard]] bool is_stated() const { return !name.empty(); }
};
static_assert(std::is_trivially_copyable_v<AircraftSettings>);

/// Reads an aircraft file; `text` is its content, `file_name` its name in error messages. Refused are: speeds without a unit,
/// speeds that are not in order (stall speed times `caution_factor` < Vno < Vne, and likewise below each limit of the flaps),
/// settings of the flaps that are not in rising order or whose limits or stall speeds rise, what is out of its range or too much,
/// unknown keys.
[[nodiscard]] base::Result<AircraftSettings, base::Error> load_aircraft(std::string_view text, std::string_view file_name);

}  // namespace tedavis::design
