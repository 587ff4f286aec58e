#include "bus/state/traffic_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include "bus/state/state_assembler.hpp"
#include "tests/support/flights/sent_traffic.hpp"

namespace tedavis::bus::test_traffic_table {
namespace {

using base::Duration;
using flight::kMaxTraffic;
using test_support::traffic_frames;
using test_support::traffic_report;

constexpr base::Time kStart{1'700'000'000'000'000'000};
base::Time at(double seconds) { return kStart + Duration::from_seconds(seconds); }

/// A bus whose messages reach the table through the decoder, as they do in flight.
class Bus {
public:
    explicit Bus(const BusSettings& settings = test_support::traffic_bus())
        : assembler(std::make_unique<StateAssembler>(settings)) {}

    void feed(const std::vector<CanFrame>& frames) { assembler->feed({frames.data(), frames.size()}); }
    void hear(std::uint32_t address, std::uint8_t number, std::uint8_t code, double seconds, double latitude_deg = 47.01) {
        feed(traffic_frames(traffic_report(address, at(seconds), latitude_deg), number, code, at(seconds)));
    }
    [[nodiscard]] flight::Traffic traffic(double seconds) const { return assembler->snapshot(at(seconds)).state.traffic; }
    [[nodiscard]] TrafficCounts counts() const { return assembler->snapshot(at(0)).counters.traffic; }
    [[nodiscard]] bool holds(std::uint32_t address, double seconds) const {
        const flight::Traffic all = traffic(seconds);
        return std::any_of(all.reports.begin(), all.reports.end(),
                           [&](const flight::TrafficReport& report) { return report.address == address; });
    }
    /// The own ship at 47 N 9.7 E.
    void place_own_ship(double seconds) {
        std::vector<CanFrame> frames(3);
        const std::int32_t units[] = {470'000'000, 97'000'000};
        for (std::size_t n = 0; n < 2; ++n) {
            CanFrame& frame = frames[n];
            frame.id = static_cast<std::uint32_t>(1036 + n);
            frame.time = at(seconds);
            frame.length = 8;
            frame.data = {7, 3, 0, ++code_};
            for (unsigned k = 0; k < 4; ++k)
                frame.data[4 + k] = static_cast<std::uint8_t>(static_cast<std::uint32_t>(units[n]) >> (24 - 8 * k));
        }
        frames[2] = frames[1];
        frames[2].id = 1038;
        frames[2].data = {7, 2, 0, ++code_, 0x44, 0xBB, 0x80, 0};
        feed(frames);
    }

    std::unique_ptr<StateAssembler> assembler;

private:
    std::uint8_t code_ = 0;
};

TEST(TrafficTable, AWholeReportIsHeldWithItsAge) {
    Bus bus;
    EXPECT_TRUE(bus.traffic(0).is_received);
    EXPECT_TRUE(bus.traffic(0).reports.empty());
    flight::TrafficReport report = traffic_report(0xA0F12B, at(-2));
    bus.feed(traffic_frames(report, 3, 0, at(0)));
    const flight::Traffic heard = bus.traffic(1);
    ASSERT_EQ(heard.reports.size(), 1u);
    EXPECT_EQ(heard.reports[0].callsign.view(), "TDV417");
    EXPECT_EQ(heard.reports[0].place.at, at(-2)) << "it was two seconds old when it was sent";
    EXPECT_NEAR(heard.reports[0].place.latitude_rad, base::radians(47.01), 1e-9);
    EXPECT_EQ(bus.counts().reports, 1u);
    EXPECT_FALSE(heard.is_cut);
    EXPECT_EQ(bus.traffic(57.9).reports.size(), 1u);
    EXPECT_EQ(bus.traffic(58.1).reports.size(), 0u) << "nobody knows any more";
}

TEST(TrafficTable, PartsMayComeInAnyOrderAndAmongOthers) {
    Bus bus;
    auto first = traffic_frames(traffic_report(1, at(0)), 0, 9, at(0)),
         second = traffic_frames(traffic_report(2, at(0)), 1, 77, at(0));
    std::vector<CanFrame> mixed;
    for (std::size_t n = 0; n < kTrafficParts; ++n) {
        mixed.push_back(first[kTrafficParts - 1 - n]);
        mixed.push_back(second[n]);
    }
    bus.feed(mixed);
    EXPECT_TRUE(bus.holds(1, 0) && bus.holds(2, 0));
    EXPECT_EQ(bus.counts().incomplete + bus.counts().repeated, 0u);
}

/// Each part missing in turn: the report is not shown, and the next whole one is.
TEST(TrafficTable, WithoutAPartThereIsNoReport) {
    for (std::size_t missing = 0; missing < kTrafficParts; ++missing) {
        Bus bus;
        auto frames = traffic_frames(traffic_report(5, at(0)), 0, 0, at(0));
        frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(missing));
        bus.feed(frames);
        EXPECT_TRUE(bus.traffic(0).reports.empty()) << missing;
        bus.hear(5, 0, 1, 1);
        EXPECT_TRUE(bus.holds(5, 1)) << missing;
        EXPECT_EQ(bus.counts().incomplete, 1u) << missing;
    }
}

/// A latitude of one report with the longitude of another would be a place where nobody is.
TEST(TrafficTable, PartsOfTwoReportsMakeNone) {
    const auto heard = [](std::uint8_t second_code, std::uint8_t second_node, double second_time) {
        Bus bus;
        auto frames = traffic_frames(traffic_report(5, at(0)), 0, 0, at(0));
        const auto next = traffic_frames(traffic_report(5, at(second_time), 48), 0, second_code, at(second_time), second_node);
        std::copy(next.begin() + 4, next.end(), frames.begin() + 4);
        bus.feed(frames);
        return bus.traffic(second_time).reports.size();
    };
    EXPECT_EQ(heard(0, 7, 0.1), 1u) << "control: the same report's";
    EXPECT_EQ(heard(1, 7, 0.1), 0u);
    EXPECT_EQ(heard(0, 8, 0.1), 0u) << "from another node";
    EXPECT_EQ(heard(0, 7, 0.6), 0u) << "too late";
}

TEST(TrafficTable, RepeatedAndOlderMessagesChangeNothing) {
    Bus bus;
    bus.hear(5, 0, 10, 0);
    bus.hear(5, 0, 10, 0.2, 48);
    bus.hear(5, 0, 9, 0.3, 49);
    EXPECT_NEAR(bus.traffic(1).reports[0].place.latitude_rad, base::radians(47.01), 1e-9);
    EXPECT_EQ(bus.counts().repeated, 2 * kTrafficParts);
    bus.hear(5, 0, 11, 1, 48);
    EXPECT_NEAR(bus.traffic(1).reports[0].place.latitude_rad, base::radians(48), 1e-9);
    bus.hear(5, 0, 3, 4, 46);
    EXPECT_NEAR(bus.traffic(4).reports[0].place.latitude_rad, base::radians(46), 1e-9) << "the sender was restarted";
}

TEST(TrafficTable, CodesGoRound) {
    Bus bus;
    for (int n = 0; n < 600; ++n) bus.hear(5, 0, static_cast<std::uint8_t>(n), n);
    EXPECT_EQ(bus.counts().reports, 600u);
    EXPECT_EQ(bus.counts().repeated + bus.counts().incomplete, 0u);
}

TEST(TrafficTable, AnImplausiblePartRefusesTheWholeReport) {
    const struct {
        TrafficPart part;
        std::array<std::uint8_t, 4> bytes;
    } bad[] = {{TrafficPart::latitude, {0x35, 0xA4, 0xE9, 0x01}},  // 90.0000001 degrees
               {TrafficPart::height, {0x7F, 0xC0, 0, 0}},          // NaN
               {TrafficPart::ground_speed, {0x7F, 0x80, 0, 0}},    // infinite
               {TrafficPart::position_deviation, {0xBF, 0x80, 0, 0}},
               {TrafficPart::callsign_begin, {'<', 'b', '>', 0}},
               {TrafficPart::address, {0, 0, 0, 0}}};
    Bus bus;
    bus.hear(5, 0, 0, 0);
    std::uint8_t code = 0;
    for (const auto& fault : bad) {
        ++code;
        auto frames = traffic_frames(traffic_report(5, at(code), 48), 0, code, at(code));
        std::copy(fault.bytes.begin(), fault.bytes.end(), frames[static_cast<std::size_t>(fault.part)].data.begin() + 4);
        bus.feed(frames);
        EXPECT_EQ(bus.counts().refused, code);
    }
    ASSERT_EQ(bus.traffic(code).reports.size(), 1u);
    EXPECT_NEAR(bus.traffic(code).reports[0].place.latitude_rad, base::radians(47.01), 1e-9) << "that of the good one";
    bus.hear(5, 32, 0, 8);
    EXPECT_EQ(bus.counts().reports, 1u) << "no such number";
    bus.hear(5, 31, 0, 9);
    EXPECT_EQ(bus.counts().reports, 2u);
}

TEST(TrafficTable, OtherTypesAndChannelsAreForeign) {
    Bus bus;
    auto frames = traffic_frames(traffic_report(5, at(0)), 0, 0, at(0));
    frames[5].data[1] = 3;  // a LONG as height
    bus.feed(frames);
    frames = traffic_frames(traffic_report(5, at(0)), 1, 0, at(0));
    for (CanFrame& frame : frames) {
        frame.extended = true;
        frame.id += 65536;
    }
    bus.feed(frames);
    EXPECT_EQ(bus.counts().reports, 0u);
    EXPECT_EQ(bus.assembler->snapshot(at(0)).counters.alien, 1 + kTrafficParts);
}

TEST(TrafficTable, AnOlderReportDoesNotTakeTheNewersPlace) {
    Bus bus;
    bus.hear(5, 0, 0, 10);
    bus.feed(traffic_frames(traffic_report(5, at(4), 48), 0, 1, at(11)));
    EXPECT_EQ(bus.counts().outdated, 1u);
    EXPECT_NEAR(bus.traffic(11).reports[0].place.latitude_rad, base::radians(47.01), 1e-9);
    bus.feed(traffic_frames(traffic_report(5, at(4), 48), 9, 0, at(11)));
    EXPECT_EQ(bus.counts().outdated, 2u) << "by another number the same";
    EXPECT_EQ(bus.traffic(11).reports.size(), 1u);
}

/// A log that was put together, or a clock that was set: what was believed of a time to come is not.
TEST(TrafficTable, WhereTimeRunsBackWhatWasIsNoMore) {
    Bus bus;
    bus.hear(5, 0, 0, 1000);
    bus.hear(6, 1, 0, 1000);
    EXPECT_TRUE(bus.traffic(0).reports.empty());
    bus.hear(5, 0, 200, 0, 48);
    ASSERT_EQ(bus.traffic(0).reports.size(), 1u);
    EXPECT_NEAR(bus.traffic(0).reports[0].place.latitude_rad, base::radians(48), 1e-9);
    EXPECT_TRUE(bus.traffic(0).reports[0].before.empty());
}

TEST(TrafficTable, AFullTableKeepsTheNearestAndSaysSo) {
    Bus bus;
    bus.place_own_ship(0);
    // 0.05 degrees apart, the nearest first; the last one is number 16.
    for (std::uint8_t n = 0; n < kMaxTraffic; ++n) bus.hear(100u + n, n, 0, 0.1, 47.1 + 0.05 * n);
    EXPECT_FALSE(bus.traffic(0.1).is_cut);
    bus.hear(200, 20, 0, 0.2, 49);
    EXPECT_FALSE(bus.holds(200, 0.2)) << "farther than all";
    EXPECT_EQ(bus.counts().no_room, 1u);
    EXPECT_TRUE(bus.traffic(0.2).is_cut);
    bus.hear(201, 21, 0, 0.3, 47.01);
    EXPECT_TRUE(bus.holds(201, 0.3)) << "nearer than all";
    EXPECT_FALSE(bus.holds(100 + kMaxTraffic - 1, 0.3)) << "the farthest gave way";
    EXPECT_EQ(bus.traffic(0.3).reports.size(), kMaxTraffic);
    EXPECT_EQ(bus.counts().no_room, 2u);
    bus.hear(100, 0, 1, 1.1, 47.1);
    EXPECT_TRUE(bus.holds(100, 1.1)) << "those that have a place keep it";
    EXPECT_TRUE(bus.traffic(10.2).is_cut);
    EXPECT_FALSE(bus.traffic(10.4).is_cut);
    bus.hear(202, 22, 0, 60.5, 49);
    EXPECT_TRUE(bus.holds(202, 60.5)) << "the places of those that are not heard any more are free";
}

TEST(TrafficTable, WithoutAnOwnPositionAFullTableTakesNoMore) {
    Bus bus;
    for (std::uint8_t n = 0; n < kMaxTraffic; ++n) bus.hear(100u + n, n, 0, 0, 47.1 + 0.05 * n);
    bus.hear(200, 20, 0, 0.2, 47.01);
    EXPECT_FALSE(bus.holds(200, 0.2));
    EXPECT_TRUE(bus.holds(100 + kMaxTraffic - 1, 0.2));
    EXPECT_EQ(bus.counts().no_room, 1u);
}

TEST(TrafficTable, KeepsTheWayOfEachAircraft) {
    Bus bus;
    for (int n = 0; n < 60; ++n) bus.hear(5, 0, static_cast<std::uint8_t>(n), n, 47 + 0.001 * n);
    const flight::TrafficReport report = bus.traffic(59).reports[0];
    ASSERT_EQ(report.before.size(), flight::kMaxTrafficPlaces);
    for (std::size_t n = 1; n < report.before.size(); ++n)
        EXPECT_EQ(report.before[n].at - report.before[n - 1].at, flight::kTrafficSpacing);
    EXPECT_LT(report.before.back().at, report.place.at);
    EXPECT_LE(report.place.at - report.before.back().at, flight::kTrafficSpacing);
    bus.hear(5, 0, 60, 59 + 31, 47.2);
    EXPECT_TRUE(bus.traffic(90).reports[0].before.empty()) << "it may have gone anywhere";
}

TEST(TrafficTable, ABusWithoutTheProfileHearsNothing) {
    Bus bus{BusSettings()};
    bus.hear(5, 0, 0, 0);
    EXPECT_FALSE(bus.traffic(0).is_received);
    EXPECT_TRUE(bus.traffic(0).reports.empty());
    EXPECT_EQ(bus.assembler->snapshot(at(0)).counters.alien, kTrafficParts);
}

/// Messages of chance: what is shown is plausible, and the same whenever it is asked.
TEST(TrafficTable, NoiseNeverShowsTheImpossible) {
    Bus bus;
    std::mt19937 random(5);
    double seconds = 0;
    for (int n = 0; n < 200'000; ++n) {
        seconds += 0.0003;
        auto frames = traffic_frames(traffic_report(1 + random() % 40, at(seconds)), static_cast<std::uint8_t>(random() % 3),
                                     static_cast<std::uint8_t>(random() % 3), at(seconds));
        CanFrame frame = frames[random() % frames.size()];
        if (random() % 4 == 0) frame.data[random() % 8] = static_cast<std::uint8_t>(random());
        bus.feed({frame});
    }
    const flight::Traffic traffic = bus.traffic(seconds);
    const TrafficCounts counts = bus.counts();
    EXPECT_GT(counts.repeated + counts.incomplete, 1000u);
    for (const flight::TrafficReport& report : traffic.reports) {
        EXPECT_TRUE(report.address > 0 && report.address <= 0xFFFFFF);
        EXPECT_LE(std::abs(report.place.latitude_rad), base::kPi / 2);
        EXPECT_TRUE(std::isfinite(report.place.height_m) && std::isfinite(report.ground_speed_mps));
        EXPECT_GE(report.place.position_deviation_m, 0);
        EXPECT_LE(report.place.at, at(seconds));
    }
}

}  // namespace
}  // namespace tedavis::bus::test_traffic_table
