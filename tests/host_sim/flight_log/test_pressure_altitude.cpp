#include "host_sim/flight_log/pressure_altitude.hpp"

#include <gtest/gtest.h>

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

TEST(PressureAltitude, GoesThereAndBack) {
    for (double qnh : {95000.0, 99000.0, 101900.0, 105000.0}) {
        for (double h = -300; h < 10000; h += 700) EXPECT_NEAR(standard_altitude(altitude_on_qnh(h, qnh), qnh), h, 1e-7);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_pressure_altitude
