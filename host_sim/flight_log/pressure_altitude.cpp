#include "host_sim/flight_log/pressure_altitude.hpp"

#include <cmath>

namespace tedavis::host_sim {
namespace {

constexpr double kSeaLevelTemperature_k = 288.15;
constexpr double kLapseRate_k_per_m = 0.0065;
constexpr double kExponent = 5.255879812716677;  // g / (R L) with g = 9.80665, R = 287.05287

/// Of the standard atmosphere.
double altitude_of_ratio(double pressure_over_standard) {
    return kSeaLevelTemperature_k / kLapseRate_k_per_m * (1.0 - std::pow(pressure_over_standard, 1.0 / kExponent));
}

}  // namespace

double standard_temperature_k(double standard_altitude_m) noexcept {
    return kSeaLevelTemperature_k - kLapseRate_k_per_m * standard_altitude_m;
}

double standard_pressure_pa(double standard_altitude_m) noexcept {
    return kStandardPressure_pa * std::pow(standard_temperature_k(standard_altitude_m) / kSeaLevelTemperature_k, kExponent);
}

double altitude_on_qnh(double standard_altitude_m, double qnh_pa) noexcept {
    return standard_altitude_m - altitude_of_ratio(qnh_pa / kStandardPressure_pa);
}

double standard_altitude(double altitude_on_qnh_m, double qnh_pa) noexcept {
    return altitude_on_qnh_m + altitude_of_ratio(qnh_pa / kStandardPressure_pa);
}

}  // namespace tedavis::host_sim
