#include "host_sim/flight_test/signal_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_signal_value {
namespace {

using flight::Signal;
using ::testing::HasSubstr;

double si_of(const std::string& key, double number) {
    std::string sentence;
    const auto unit = read_signal_key(key, sentence);
    EXPECT_TRUE(unit) << sentence;
    return unit ? unit->to_si(number) : NAN;
}

std::string refusal_of(const std::string& key) {
    std::string sentence;
    EXPECT_FALSE(read_signal_key(key, sentence));
    return sentence;
}

TEST(SignalValue, UnitsAreExact) {
    EXPECT_NEAR(si_of("indicated_airspeed_kt", 90), 46.3, 1e-9) << "90 x 1852 / 3600";
    EXPECT_NEAR(si_of("vertical_speed_fpm", 1000), 5.08, 1e-12);
    EXPECT_NEAR(si_of("baro_altitude_ft", 1000), 304.8, 1e-9);
    EXPECT_NEAR(si_of("pitch_deg", 180), 3.14159265358979, 1e-12);
    EXPECT_NEAR(si_of("baro_setting_hpa", 1013.25), 101325, 1e-9);
    EXPECT_NEAR(si_of("outside_temperature_c", 15), 288.15, 1e-9);
    EXPECT_NEAR(si_of("normal_acceleration_g", 1), 9.80665, 1e-12);
    EXPECT_EQ(si_of("flaps_position", 0.5), 0.5) << "a share has no unit";
}

TEST(SignalValue, AnUnknownSignalNamesTheNearest) {
    EXPECT_THAT(refusal_of("indicated_airsped_kt"), HasSubstr("say indicated_airspeed"));
    EXPECT_THAT(refusal_of("height_above_terrain_m"), HasSubstr("is no signal of the bus")) << "the display computes it";
}

TEST(SignalValue, AMissingOrWrongUnitNamesTheRightOnes) {
    EXPECT_EQ(refusal_of("pitch"), "'pitch' does not say the unit; say pitch_deg or pitch_rad");
    EXPECT_EQ(refusal_of("pitch_kt"), "kt is no unit of 'pitch'; say pitch_deg or pitch_rad");
    EXPECT_EQ(refusal_of("flaps_position_deg"), "deg is no unit of 'flaps_position'; say flaps_position");
}

std::string fault_of(const std::string& key, double low, double high) {
    std::string sentence;
    return fault_of_range(key, *read_signal_key(key, sentence), low, high);
}

TEST(SignalValue, ARangeReachesIntoWhatTheBusCarries) {
    EXPECT_THAT(fault_of("true_heading_deg", 361, 365), HasSubstr("'true_heading_deg' must be -180 to 360"));
    EXPECT_THAT(fault_of("pitch_deg", -100, -91), HasSubstr("must be -90 to 90"));
    EXPECT_THAT(fault_of("outside_temperature_c", -400, -300), HasSubstr("'outside_temperature_c' must be "));
    EXPECT_EQ(fault_of("true_heading_deg", 355, 365), "");
    EXPECT_EQ(fault_of("pitch_deg", -900, 900), "") << "all values";
}

TEST(SignalValue, EverySignalOfTheBusHasAKey) {
    for (const std::string& name : bus_signal_names()) {
        std::string sentence;
        const bool is_bare = read_signal_key(name, sentence).has_value();
        EXPECT_TRUE(is_bare || sentence.find("say " + name + "_") != std::string::npos) << sentence;
    }
}

TEST(SignalValue, GroupsHoldTheirSignals) {
    EXPECT_EQ(signals_named("pitch"), std::vector<Signal>{Signal::pitch});
    EXPECT_EQ(signals_named("position").size(), 3u);
    EXPECT_EQ(signals_named("all").size(), bus_signal_names().size());
    EXPECT_TRUE(signals_named("nothing").empty());
    for (const std::string& name : signal_group_names()) EXPECT_FALSE(signals_named(name).empty()) << name;
}

}  // namespace
}  // namespace tedavis::host_sim::test_signal_value
