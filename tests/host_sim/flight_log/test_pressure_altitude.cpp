#include "host_sim/flight_log/pressure_altitude.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_pressure_altitude {
namespace {

// Tables of the ICAO standard atmosphere (Doc 7488): pressure and temperature by altitude.
TEST(PressureAltitude, AgreesWithTheStandardAtmospheresTable) {
    EXPECT_NEAR(standard_pressure_pa(0), 101325.0, 1e-9);
    EXPECT_NEAR(standard_pressure_pa(1000), 89874.6, 0.2);
    EXPECT_NEAR(standard_pressure_pa(5000), 54019.9, 0.3);
    EXPECT_NEAR(standard_pressure_pa(11000), 22632.1, 0.3);
    EXPECT_NEAR(standard_temperature_k(5000), 255.65, 1e-9);
}

TEST(PressureAltitude, StandardSettingChangesNothing) {
    for (double h = -300; h < 11000; h += 500) {
        EXPECT_NEAR(altitude_on_qnh(h, kStandardPressure_pa), h, 1e-8);
        EXPECT_NEAR(standard_altitude(h, kStandardPressure_pa), h, 1e-8);
    }
}

TEST(PressureAltitude, OneHectopascalIsAboutEightMetresAtSeaLevel) {
    EXPECT_NEAR(altitude_on_qnh(0, 101425), 8.3, 0.1);
    EXPECT_NEAR(altitude_on_qnh(0, 101225), -8.3, 0.1);
}

/// dh = -R T / (g p) dp with T = T0 - L h, integrated from the standard pressure, without the closed formula.
double integrated_altitude_m(double pressure_pa) {
    constexpr int kSteps = 200'000;
    const double step = std::log(pressure_pa / 101325.0) / kSteps;
    double h = 0;
    for (int n = 0; n < kSteps; ++n) {
        const double middle = h - step / 2 * 287.05287 / 9.80665 * (288.15 - 0.0065 * h);
        h -= step * 287.05287 / 9.80665 * (288.15 - 0.0065 * middle);
    }
    return h;
}

/// An altimeter shows the height of the pressure it measures less the height of the pressure it is set to.
TEST(PressureAltitude, TheSubscaleShiftsByTheHeightOfItsPressure) {
    for (const double qnh_pa : {95000.0, 98000.0, 101325.0, 103000.0, 105000.0}) {
        const double shift_m = -integrated_altitude_m(qnh_pa);
        for (const double pressure_pa : {103500.0, 89874.6, 70000.0, 54019.9, 30000.0}) {
            const double standard_m = integrated_altitude_m(pressure_pa);
            EXPECT_NEAR(altitude_on_qnh(standard_m, qnh_pa), standard_m + shift_m, 1e-4) << qnh_pa << " at " << pressure_pa;
            EXPECT_NEAR(standard_altitude(standard_m + shift_m, qnh_pa), standard_m, 1e-4);
        }
    }
    EXPECT_NEAR(altitude_on_qnh(10000, 103000) - 10000, altitude_on_qnh(0, 103000), 1e-9) << "as much aloft as at sea level";
}

TEST(PressureAltitude, GoesThereAndBack) {
    for (double qnh : {95000.0, 99000.0, 101900.0, 105000.0}) {
        for (double h = -300; h < 10000; h += 700) EXPECT_NEAR(standard_altitude(altitude_on_qnh(h, qnh), qnh), h, 1e-7);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_pressure_altitude
