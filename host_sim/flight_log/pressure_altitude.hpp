/// Pressure altitudes of the ICAO standard atmosphere (ICAO Doc 7488, troposphere) and an altimeter's QNH setting.
/// Valid up to 11,000 m; metres and pascals.
#pragma once

namespace tedavis::host_sim {

inline constexpr double kStandardPressure_pa = 101325.0;

/// The indication of an altimeter set to `qnh_pa` where one set to 1013.25 hPa indicates `standard_altitude_m`. It is lower by
/// the altitude of the pressure `qnh_pa` in the standard atmosphere, which is the same at each altitude.
[[nodiscard]] double altitude_on_qnh(double standard_altitude_m, double qnh_pa) noexcept;
/// The inverse of altitude_on_qnh.
[[nodiscard]] double standard_altitude(double altitude_on_qnh_m, double qnh_pa) noexcept;
/// Temperature of the standard atmosphere, K.
[[nodiscard]] double standard_temperature_k(double standard_altitude_m) noexcept;
/// Static pressure at a standard altitude, Pa.
[[nodiscard]] double standard_pressure_pa(double standard_altitude_m) noexcept;

}  // namespace tedavis::host_sim
