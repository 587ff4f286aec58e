#include "bus/canaerospace/traffic_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

#include "tests/support/files/paths.hpp"
#include "tests/support/flights/sent_traffic.hpp"

namespace tedavis::bus::test_traffic_profile {
namespace {

constexpr base::Time kNow{1'700'000'000'500'000'000};

TypedValue value_in(const CanFrame& frame) {
    TypedValue value;
    EXPECT_TRUE(decode_value(frame.data[1], frame.data.data() + 4, frame.length - 4u, value));
    return value;
}

TrafficNumbers numbers_in(const std::vector<CanFrame>& frames) {
    TrafficNumbers numbers{};
    for (std::size_t n = 0; n < kTrafficParts; ++n)
        EXPECT_TRUE(decode_traffic_part(static_cast<TrafficPart>(n), value_in(frames[n]), numbers[n])) << n;
    return numbers;
}

std::string bytes_of(const CanFrame& frame) {
    std::string text;
    char digits[3];
    for (std::size_t n = 0; n < frame.length; ++n) {
        std::snprintf(digits, sizeof digits, "%02X", frame.data[n]);
        text += digits;
    }
    return text;
}

/// By hand, from the standard's types and the table in configs/buses/README.md.
TEST(TrafficProfile, TheBytesAreTheDocumentedOnes) {
    flight::TrafficReport report = test_support::traffic_report(0xA0F12B, kNow - base::Duration::seconds(2), -36.5, 84.25);
    report.true_track_rad = static_cast<float>(base::radians(90));
    const auto frames = test_support::traffic_frames(report, 5, 0xFE, kNow);
    ASSERT_EQ(frames.size(), 12u);
    const char* const expected[] = {
        "070405FE00A0F12B",  // ULONG
        "071905FE54445634",  // ACHAR4 "TDV4"
        "071905FE31372020",  // "17  "
        "070305FEEA3E8AC0",  // LONG -365000000
        "070305FE323787A0",  // LONG 842500000
        "070205FE44BB9000",  // FLOAT 1500.5
        "070205FE42700000",  // 60
        "070205FE42B40000",  // 90
        "070205FE40200000",  // 2.5
        "070205FE42200000",  // 40
        "070205FE41A00000",  // 20
        "070205FE40000000",  // 2
    };
    for (std::size_t n = 0; n < 12; ++n) {
        EXPECT_EQ(frames[n].id, 1840u + n);
        EXPECT_FALSE(frames[n].extended);
        EXPECT_EQ(bytes_of(frames[n]), expected[n]) << n;
    }
}

TEST(TrafficProfile, WhatGoesInComesOut) {
    const flight::TrafficReport sent =
        test_support::traffic_report(0xFFFFFF, kNow - base::Duration::seconds(3), 89.9999999, -180);
    const flight::TrafficReport heard = traffic_report(numbers_in(test_support::traffic_frames(sent, 0, 0, kNow)), kNow);
    EXPECT_EQ(heard.address, sent.address);
    EXPECT_EQ(heard.callsign, sent.callsign);
    EXPECT_NEAR(heard.place.latitude_rad, sent.place.latitude_rad, 1e-9);
    EXPECT_NEAR(heard.place.longitude_rad, -base::kPi, 1e-9);
    EXPECT_EQ(heard.place.at, sent.place.at);
    EXPECT_EQ(heard.place.height_m, sent.place.height_m);
    EXPECT_EQ(heard.place.position_deviation_m, 40);
    EXPECT_EQ(heard.place.height_deviation_m, 20);
    EXPECT_EQ(heard.ground_speed_mps, 60);
    EXPECT_NEAR(static_cast<double>(heard.true_track_rad), base::radians(45), 1e-6);
    EXPECT_EQ(heard.climb_mps, 2.5f);
    EXPECT_TRUE(heard.before.empty());
}

TEST(TrafficProfile, ImplausiblePartsAreRefused) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
    double number = 0;
    for (std::size_t n = 0; n < kTrafficParts; ++n) {
        const auto part = static_cast<TrafficPart>(n);
        const TrafficPartEntry& entry = traffic_part_entry(part);
        if ((entry.types & (1u << static_cast<unsigned>(DataType::float32))) == 0) continue;
        const auto accepts = [&](double stated) {
            return decode_traffic_part(part, {DataType::float32, 1, static_cast<float>(stated), {}}, number);
        };
        EXPECT_TRUE(accepts(entry.low) && accepts(entry.high)) << entry.name;
        EXPECT_FALSE(accepts(entry.low - 0.01) || accepts(entry.high * 1.001) || accepts(kNaN) || accepts(kInfinity))
            << entry.name;
    }
    const auto accepts_long = [&](TrafficPart part, std::int64_t units) {
        return decode_traffic_part(part, {DataType::long32, 1, 0, {units}}, number);
    };
    EXPECT_TRUE(accepts_long(TrafficPart::latitude, 900'000'000));
    EXPECT_FALSE(accepts_long(TrafficPart::latitude, 900'000'001));
    EXPECT_TRUE(accepts_long(TrafficPart::longitude, -1'800'000'000));
    EXPECT_FALSE(accepts_long(TrafficPart::longitude, 1'800'000'001));
    const auto accepts_address = [&](std::int64_t address) {
        return decode_traffic_part(TrafficPart::address, {DataType::ulong32, 1, 0, {address}}, number);
    };
    EXPECT_TRUE(accepts_address(1) && accepts_address(0xFFFFFF));
    EXPECT_FALSE(accepts_address(0) || accepts_address(0x1000000));
    EXPECT_FALSE(decode_traffic_part(TrafficPart::callsign_begin, {DataType::achar8x4, 4, 0, {'A', 'b', ' ', ' '}}, number));
    EXPECT_FALSE(decode_traffic_part(TrafficPart::callsign_end, {DataType::achar8x4, 4, 0, {'A', 0, 0, 0}}, number));
}

TEST(TrafficProfile, WhatCannotBeSaidIsNotSent) {
    flight::TrafficReport report = test_support::traffic_report(7, kNow);
    EXPECT_EQ(test_support::traffic_frames(report, 31, 0, kNow).size(), kTrafficParts);
    EXPECT_EQ(test_support::traffic_frames(report, 32, 0, kNow).size(), 0u);
    EXPECT_EQ(test_support::traffic_frames(report, 0, 0, kNow + base::Duration::seconds(61)).size(), 0u) << "too old";
    report.place.height_m = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(test_support::traffic_frames(report, 0, 0, kNow).size(), 0u);
}

/// The shipped .dbc and README name all parts, with their identifiers from the shipped bus file's on, units and types.
TEST(TrafficProfile, ShippedDescriptionsAgree) {
    const auto text_of = [](const char* name) {
        std::ifstream file(test_support::source_dir() + "/configs/buses/" + name);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    };
    const std::string dbc = text_of("canaerospace.dbc"), readme = text_of("README.md");
    for (std::size_t n = 0; n < kTrafficParts; ++n) {
        const TrafficPartEntry& entry = traffic_part_entry(static_cast<TrafficPart>(n));
        const std::string identifier = std::to_string(1840 + n);
        const std::size_t message = dbc.find("\nBO_ " + identifier + " " + entry.name + ": 8 ");
        ASSERT_NE(message, std::string::npos) << entry.name;
        const std::string signals = dbc.substr(message, dbc.find("\n\n", message) - message);
        EXPECT_NE(signals.find(std::string("\"") + entry.unit + "\""), std::string::npos) << entry.name;
        const bool is_float = (entry.types & (1u << static_cast<unsigned>(DataType::float32))) != 0;
        EXPECT_EQ(dbc.find("SIG_VALTYPE_ " + identifier + " Value : 1;") != std::string::npos, is_float) << entry.name;
        EXPECT_NE(readme.find("| " + identifier + " | "), std::string::npos) << entry.name;
    }
}

}  // namespace
}  // namespace tedavis::bus::test_traffic_profile
