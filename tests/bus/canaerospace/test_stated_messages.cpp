#include "bus/canaerospace/stated_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bus/canaerospace/message_decoder.hpp"
#include "bus/state/state_assembler.hpp"
#include "render_core/base/units.hpp"
#include "tests/bus/golden_frames.hpp"

namespace tedavis::bus::test_stated_messages {
namespace {

using base::radians;
using flight::Signal;
using ::testing::HasSubstr;

BusSettings settings_of(const std::string& tables) {
    const auto read = load_bus_settings(tables, "bus.toml");
    EXPECT_TRUE(read.ok()) << read.error().message.view();
    return read.ok() ? read.value() : BusSettings();
}

std::string fault_of(const std::string& tables) {
    const auto read = load_bus_settings(tables, "bus.toml");
    return read.ok() ? "accepted" : std::string(read.error().message.view());
}

DecodedMessage decoded(const BusSettings& settings, const std::string& content) {
    MessageDecoder decoder(settings);
    return decoder.decode(frame_of(content));
}

constexpr const char* kHeightInFeet =
    "[[message]]\nsignal = \"radio_height\"\nidentifier = 1860\ntype = \"LONG\"\nunit = \"ft\"\nscale = 0.01\n";

TEST(StatedMessages, ASensorOnAnotherIdentifierInAnotherUnit) {
    const BusSettings settings = settings_of(kHeightInFeet);
    // 1860 is 744 hex; LONG 3; 12345 hundredths of a foot are 3039 hex.
    const DecodedMessage message = decoded(settings, "744#0103000000003039");
    ASSERT_EQ(message.kind, MessageKind::signal);
    EXPECT_TRUE(message.healthy);
    EXPECT_EQ(message.signal, Signal::radio_height);
    EXPECT_NEAR(message.value, 123.45 * 0.3048, 1e-9);
    EXPECT_EQ(decoded(settings, "744#0102000041200000").kind, MessageKind::alien) << "a FLOAT, which the file does not say";
    EXPECT_EQ(decoded(BusSettings(), "744#0103000000003039").kind, MessageKind::alien) << "control: without the table";
}

TEST(StatedMessages, TheStandardsIdentifierOfTheSignalIsForeignThen) {
    constexpr const char* kStandard = "42E#0102000041200000";  // 1070: 10 m
    EXPECT_EQ(decoded(BusSettings(), kStandard).kind, MessageKind::signal);
    EXPECT_EQ(decoded(settings_of(kHeightInFeet), kStandard).kind, MessageKind::alien);
}

TEST(StatedMessages, AnIdentifierOfTheStandardMayMeanWhatTheFileSays) {
    const BusSettings feet = settings_of("[[message]]\nsignal = \"baro_altitude\"\nidentifier = 320\nunit = \"ft\"\n");
    // 320 is 140 hex; 1000 is 447A0000 as a FLOAT.
    EXPECT_NEAR(decoded(feet, "140#01020000447A0000").value, 304.8, 1e-9);
    EXPECT_NEAR(decoded(BusSettings(), "140#01020000447A0000").value, 1000, 1e-9);
}

TEST(StatedMessages, UnitsWithAZeroOfTheirOwn) {
    const BusSettings celsius = settings_of(
        "[[message]]\nsignal = \"outside_temperature\"\nidentifier = 1861\ntype = \"SHORT\"\nunit = \"degC\"\nscale = 0.1\n");
    // 1861 is 745 hex; SHORT 6; -55 tenths are FFC9.
    EXPECT_NEAR(decoded(celsius, "745#01060000FFC9").value, 273.15 - 5.5, 1e-9);
    const BusSettings shifted = settings_of(
        "[[message]]\nsignal = \"pitch\"\nidentifier = 1862\ntype = \"USHORT\"\nunit = \"deg\"\nscale = 0.01\noffset = -90\n");
    // 1862 is 746 hex; USHORT 7; 9500 hundredths less 90 degrees.
    EXPECT_NEAR(decoded(shifted, "746#01070000251C").value, radians(5.0), 1e-12);
}

TEST(StatedMessages, SignsAndReferencesOfTheDialectHold) {
    const std::string wind = "[[message]]\nsignal = \"wind_direction\"\nidentifier = 1863\nunit = \"rad\"\n";
    // 1863 is 747 hex; 1 radian.
    EXPECT_NEAR(decoded(settings_of(wind), "747#010200003F800000").value, 1, 1e-7);
    EXPECT_NEAR(decoded(settings_of("[dialect]\nwind_direction = \"to\"\n" + wind), "747#010200003F800000").value, 1 + base::kPi,
                1e-7);
    const std::string load =
        "[dialect]\nacceleration_unit = \"m/s2\"\n[[message]]\nsignal = \"normal_acceleration\"\nidentifier = 1864\n";
    // 1864 is 748 hex; without a unit it is the standard's, whatever the dialect of the standard's own identifiers.
    EXPECT_NEAR(decoded(settings_of(load), "748#010200003F800000").value, base::kStandardGravity, 1e-6);
}

TEST(StatedMessages, AnImplausibleValueIsRefusedAsEver) {
    const BusSettings settings = settings_of(kHeightInFeet);
    MessageDecoder decoder(settings);
    EXPECT_FALSE(decoder.decode(frame_of("744#010300007FFFFFFF")).healthy) << "6546 km";
    EXPECT_EQ(decoder.counts().out_of_range, 1u);
    EXPECT_FALSE(decoded(settings, "744#0103050000003039").healthy) << "its service code states invalid";
    EXPECT_TRUE(decoded(settings, "744#01000000").nothing_selected) << "NODATA: no ground is in range, as by 1070";
}

TEST(StatedMessages, ReachTheStateWithTheirFreshness) {
    const BusSettings settings = settings_of(std::string(kHeightInFeet) + "period_s = 0.5\n");
    const base::FreshnessLimits& limits = settings.limits[static_cast<std::size_t>(Signal::radio_height)];
    EXPECT_NEAR(limits.stale.to_seconds(), 1.5, 1e-9);
    EXPECT_NEAR(limits.lost.to_seconds(), 4.5, 1e-9);
    StateAssembler assembler(settings);
    const CanFrame frame = frame_of("744#0103000000003039", 1'000'000'000);
    assembler.feed({&frame, 1});
    const auto at = [&](double seconds) {
        const base::Time now = base::Time{} + base::Duration::from_seconds(seconds);
        return assembler.snapshot(now).state.state_of(Signal::radio_height, now);
    };
    EXPECT_EQ(at(2.4), base::SignalState::valid);
    EXPECT_EQ(at(2.6), base::SignalState::stale);
    EXPECT_EQ(at(5.6), base::SignalState::lost);
    const BusSettings stated =
        settings_of(std::string(kHeightInFeet) + "period_s = 0.5\n[freshness]\nradio_height = [0.2, 0.4]\n");
    EXPECT_NEAR(stated.limits[static_cast<std::size_t>(Signal::radio_height)].lost.to_seconds(), 4.5, 1e-9)
        << "what its own table says comes before [freshness], which the shipped file states of every signal";
    const BusSettings quick = settings_of(std::string(kHeightInFeet) + "period_s = 0.01\n");
    EXPECT_NEAR(quick.limits[static_cast<std::size_t>(Signal::radio_height)].stale.to_seconds(), 0.3, 1e-9);
    EXPECT_NEAR(settings_of(std::string(kHeightInFeet) + "period_s = 0.1\n")
                    .limits[static_cast<std::size_t>(Signal::radio_height)]
                    .stale.to_seconds(),
                1, 1e-9);
}

TEST(StatedMessages, FaultsNameLineAndRemedy) {
    const std::string one(kHeightInFeet);
    EXPECT_EQ(
        fault_of("[[message]]\nsignal = \"speed\"\nidentifier = 1860\n").find("bus.toml:2: no such signal on the bus; choose"),
        0u);
    EXPECT_THAT(fault_of("[[message]]\nsignal = \"height_above_terrain\"\nidentifier = 1860\n"), HasSubstr("no such signal"));
    EXPECT_THAT(fault_of("[[message]]\nsignal = \"pitch\"\nidentifier = 1860\nunit = \"ft\"\n"),
                HasSubstr("bus.toml:4: 'unit' must be one of: deg rad"));
    EXPECT_THAT(fault_of("[[message]]\nsignal = \"pitch\"\nidentifier = 1860\ntype = \"INT\"\n"),
                HasSubstr("'type' must be one of: FLOAT, SHORT2"));
    EXPECT_THAT(fault_of("[[message]]\nsignal = \"pitch\"\nidentifier = 1860\nscale = 0\n"), HasSubstr("'scale' must not be 0"));
    EXPECT_THAT(fault_of("[[message]]\nsignal = \"pitch\"\nidentifier = 128\n"), HasSubstr("'identifier'"));
    EXPECT_THAT(fault_of(one + "[[message]]\nsignal = \"pitch\"\nidentifier = 1860\n"),
                HasSubstr("bus.toml:9: another [[message]] has this identifier; give each its own"));
    EXPECT_THAT(fault_of(one + "[[message]]\nsignal = \"radio_height\"\nidentifier = 1861\n"),
                HasSubstr("bus.toml:8: another [[message]] states this signal; keep one of them"));
    EXPECT_THAT(fault_of("[[message]]\nsignal = \"pitch\"\nidentifier = 1830\n"),
                HasSubstr("this identifier states the phase of flight already; choose another"));
    EXPECT_THAT(fault_of("[traffic]\nfirst_identifier = 1840\n[[message]]\nsignal = \"pitch\"\nidentifier = 1851\n"),
                HasSubstr("states other aircraft already"));
    EXPECT_THAT(fault_of("[guidance]\nfirst_identifier = 1832\n[[message]]\nsignal = \"pitch\"\nidentifier = 1833\n"),
                HasSubstr("states what is selected ([guidance]) already"));
    std::string many;
    for (int n = 0; n < 17; ++n)
        many += "[[message]]\nsignal = \"" + std::string(flight::to_string(static_cast<Signal>(n))) +
                "\"\nidentifier = " + std::to_string(1860 + n) + "\n";
    EXPECT_THAT(fault_of(many), HasSubstr("a bus file has at most 16 [[message]] tables; remove some"));
}

}  // namespace
}  // namespace tedavis::bus::test_stated_messages
