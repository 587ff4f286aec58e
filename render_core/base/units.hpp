/// Conversion factors between the cockpit's units and SI. Inside the core everything is SI and radians; names carry the unit
/// (`_m`, `_mps`, `_rad`, `_pa`, `_k`). These factors are used only at interfaces: bus decoding, configuration, display, files.
#pragma once

namespace tedavis::base {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / kPi;
inline constexpr double kMetresPerFoot = 0.3048;          // exact, international foot
inline constexpr double kMetresPerNauticalMile = 1852.0;  // exact
inline constexpr double kMpsPerKnot = kMetresPerNauticalMile / 3600.0;
inline constexpr double kMpsPerFootPerMinute = kMetresPerFoot / 60.0;
inline constexpr double kMpsPerKilometreAnHour = 1.0 / 3.6;
inline constexpr double kPascalsPerHectopascal = 100.0;
inline constexpr double kStandardGravity = 9.80665;  // m/s^2, exact

[[nodiscard]] constexpr double radians(double degrees) { return degrees * kRadiansPerDegree; }
[[nodiscard]] constexpr double degrees(double radians) { return radians * kDegreesPerRadian; }

}  // namespace tedavis::base
