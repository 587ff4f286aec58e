#include "target/self_test/known_flight.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <sstream>
#include <string>

#include "render_core/base/units.hpp"
#include "render_core/display/display.hpp"
#include "target/self_test.hpp"

namespace tedavis::target::test_known_flight {
namespace {

using flight::Signal;

KnownFlight play() {
    display::Display no_display;
    return play_known_flight(embedded_inputs().log, bus::BusSettings(), no_display.planner());
}

/// The last four data bytes of each identifier, by a reader that knows nothing but the text of the log.
std::map<int, float> last_floats() {
    std::map<int, float> values;
    std::istringstream log(std::string(embedded_inputs().log.begin(), embedded_inputs().log.end()));
    std::string stamp, interface_name, frame;
    while (log >> stamp >> interface_name >> frame) {
        const std::size_t hash = frame.find('#');
        const auto word = static_cast<std::uint32_t>(std::stoul(frame.substr(hash + 9, 8), nullptr, 16));
        std::memcpy(&values[std::stoi(frame.substr(0, hash), nullptr, 16)], &word, sizeof word);
    }
    return values;
}

TEST(KnownFlight, IsWhatTheBytesOfTheLogSay) {
    const KnownFlight flight = play();
    std::map<int, float> bytes = last_floats();
    const std::map<int, std::pair<Signal, double>> identifiers = {{311, {Signal::pitch, base::kDegreesPerRadian}},
                                                                  {312, {Signal::roll, base::kDegreesPerRadian}},
                                                                  {1133, {Signal::true_heading, base::kDegreesPerRadian}},
                                                                  {320, {Signal::baro_altitude, 1}},
                                                                  {315, {Signal::indicated_airspeed, 1}},
                                                                  {319, {Signal::baro_setting, 0.01}},
                                                                  {1039, {Signal::ground_speed, 1}},
                                                                  {335, {Signal::outside_temperature, 1}}};
    for (const auto& [identifier, meaning] : identifiers)
        EXPECT_NEAR(flight.aircraft[meaning.first].value_or(0) * meaning.second, bytes.at(identifier), 1e-5) << identifier;
}

TEST(KnownFlight, EveryCheckHoldsExceptWhatNeedsTerrain) {
    SelfTestReport report;
    check_known_flight(play(), report);
    EXPECT_GE(report.checks().size(), 20u);
    for (const SelfCheck& check : report.checks())
        EXPECT_EQ(check.holds, check.name.view() != "height_above_terrain") << check.name.view() << ": " << check.finding.view();
}

TEST(KnownFlight, EveryKnownValueIsLookedAt) {
    const KnownFlight good = play();
    for (const Signal signal : {Signal::true_heading, Signal::pitch, Signal::roll, Signal::baro_altitude, Signal::baro_setting,
                                Signal::indicated_airspeed, Signal::ground_speed, Signal::vertical_speed, Signal::wind_speed,
                                Signal::outside_temperature}) {
        KnownFlight bad = good;
        bad.aircraft[signal] =
            base::Stamped<double>(good.aircraft[signal].value_or(0) + (signal == Signal::baro_setting ? 10 : 0.01), good.now);
        SelfTestReport report;
        check_known_flight(bad, report);
        const SelfCheck* check =
            report.find(flight::to_string(signal) == std::string("true_heading") ? "heading" : flight::to_string(signal));
        ASSERT_NE(check, nullptr);
        EXPECT_FALSE(check->holds) << check->name.view();
    }
    KnownFlight elsewhere = good;
    elsewhere.aircraft.own_ship.position.latitude_rad += 2e-7;  // 1.3 m
    elsewhere.phase.phase = flight::kApproachFinal;
    elsewhere.aircraft[Signal::pitch] = {};
    SelfTestReport report;
    check_known_flight(elsewhere, report);
    EXPECT_FALSE(report.find("latitude")->holds);
    EXPECT_FALSE(report.find("phase")->holds);
    EXPECT_EQ(report.find("pitch")->finding.view(), "missing");
}

}  // namespace
}  // namespace tedavis::target::test_known_flight
