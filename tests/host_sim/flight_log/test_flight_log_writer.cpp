#include "host_sim/flight_log/flight_log_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <sstream>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "host_sim/flight_log/message_schedule.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/flights/sent_traffic.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flight_log_writer {
namespace {

using flight::Signal;

const base::Time kBegin{1'700'000'000'000'000'000};

/// Known signals; silent between 4 and 6 s; states a phase from 1 s on, another from 2.5 s on.
class KnownFlight final : public FlightSource {
public:
    base::Time begin() const override { return kBegin; }
    base::Time end() const override { return kBegin + base::Duration::seconds(10); }
    std::optional<SignalSample> at(base::Time time) const override {
        const double s = (time - kBegin).to_seconds();
        if (s > 4 && s < 6) return std::nullopt;
        SignalSample sample;
        sample[Signal::latitude] = base::radians(46.5) + 1e-6 * s;
        sample[Signal::longitude] = base::radians(-84.123456789);
        sample[Signal::ellipsoid_height] = 1500;
        sample[Signal::ground_speed] = 6.37;
        sample[Signal::true_track] = 0;
        sample[Signal::pitch] = base::radians(5);
        sample[Signal::roll] = base::radians(-12.5);
        sample[Signal::true_heading] = base::radians(350);
        sample[Signal::baro_setting] = 101900;
        sample[Signal::wind_direction] = base::radians(200);
        sample[Signal::vertical_speed] = -1.5;
        return sample;
    }
    std::optional<flight::FlightPhase> stated_phase(base::Time time) const override {
        const double s = (time - kBegin).to_seconds();
        if (s < 1) return std::nullopt;
        return s < 2.5 ? flight::kTakeoffStart : flight::kTakeoffFirstClimb;
    }
};

struct Written {
    std::string text;
    FlightLogCounts counts;
};

Written write(const FlightSource& flight) {
    std::ostringstream stream;
    const FlightLogCounts counts = write_flight_log(flight, FlightLogSettings(), stream, [](double) { return true; });
    return {stream.str(), counts};
}

std::vector<bus::CanFrame> read_back(const std::string& text) {
    bus::CandumpLogSource source({text.data(), text.size()});
    std::vector<bus::CanFrame> frames(200'000);
    frames.resize(source.read(base::Time{INT64_MAX}, {frames.data(), frames.size()}));
    EXPECT_EQ(source.statistics().malformed, 0u);
    return frames;
}

TEST(FlightLogWriter, WhatGoesInComesOutOfTheDecoder) {
    const Written written = write(KnownFlight());
    const auto frames = read_back(written.text);
    EXPECT_EQ(frames.size(), written.counts.frames);
    const auto assembler = std::make_unique<bus::StateAssembler>();
    const base::Time now = kBegin + base::Duration::milliseconds(3500);
    std::size_t count = 0;
    while (count < frames.size() && frames[count].time <= now) ++count;
    assembler->feed({frames.data(), count});
    const bus::BusSnapshot snapshot = assembler->snapshot(now);
    const auto value = [&](Signal signal) { return snapshot.state[signal].value_or(-1e9); };
    EXPECT_NEAR(value(Signal::latitude), base::radians(46.5) + 3.4e-6, 2e-7);
    EXPECT_NEAR(value(Signal::longitude), base::radians(-84.123456789), 1e-14) << "positions keep all digits of a double";
    EXPECT_NEAR(value(Signal::ellipsoid_height), 1500, 1e-3);
    EXPECT_NEAR(value(Signal::pitch), base::radians(5), 1e-7);
    EXPECT_NEAR(value(Signal::roll), base::radians(-12.5), 1e-7);
    EXPECT_NEAR(value(Signal::true_heading), base::radians(350), 1e-6);
    EXPECT_NEAR(value(Signal::baro_setting), 101900, 0.1);
    EXPECT_NEAR(value(Signal::wind_direction), base::radians(200), 1e-6);
    EXPECT_NEAR(value(Signal::vertical_speed), -1.5, 1e-6);
    EXPECT_FALSE(snapshot.state[Signal::radio_height].received());
    EXPECT_FALSE(snapshot.state[Signal::indicated_airspeed].received());
    EXPECT_EQ(snapshot.phase_status.phase.value_or(flight::FlightPhase{}), flight::kTakeoffFirstClimb);
    EXPECT_EQ(snapshot.decoder.lost, 0u);
    EXPECT_EQ(snapshot.decoder.out_of_range, 0u);
    EXPECT_EQ(snapshot.counters.alien, 0u);
    EXPECT_EQ(snapshot.state.utc.state, base::SignalState::valid);
    EXPECT_NEAR(snapshot.state.utc.ahead.to_seconds(), 0, 0.01) << "its stamps are UTC";
}

/// Above 100 m the radio altimeter has no ground in range.
class FlightWithRadioHeight final : public FlightSource {
public:
    base::Time begin() const override { return kBegin; }
    base::Time end() const override { return kBegin + base::Duration::seconds(20); }
    std::optional<SignalSample> at(base::Time time) const override {
        const double height_m = 10 * (time - kBegin).to_seconds();
        SignalSample sample;
        sample[Signal::latitude] = base::radians(46.5);
        sample[Signal::longitude] = base::radians(-84.1);
        if (height_m < 100) sample[Signal::radio_height] = height_m;
        return sample;
    }
    std::optional<flight::FlightPhase> stated_phase(base::Time) const override { return std::nullopt; }
};

TEST(FlightLogWriter, ARadioAltimeterOutOfRangeSaysSoAndIsNotLost) {
    const auto frames = read_back(write(FlightWithRadioHeight()).text);
    const auto state_at = [&](double s) {
        const base::Time now = kBegin + base::Duration::from_seconds(s);
        std::size_t count = 0;
        while (count < frames.size() && frames[count].time <= now) ++count;
        const auto assembler = std::make_unique<bus::StateAssembler>();
        assembler->feed({frames.data(), count});
        return assembler->snapshot(now).state.state_of(Signal::radio_height, now);
    };
    EXPECT_EQ(state_at(9), base::SignalState::valid);
    for (const double s : {10.5, 12.0, 19.0}) EXPECT_EQ(state_at(s), base::SignalState::missing) << s;
    const auto others = read_back(write(KnownFlight()).text);
    EXPECT_TRUE(std::none_of(others.begin(), others.end(), [](const bus::CanFrame& frame) { return frame.id == 1070; }))
        << "an aircraft without one says nothing of it";
}

/// Two aircraft, the second of which cannot be said after a while.
class FlightAmongOthers final : public FlightSource {
public:
    base::Time begin() const override { return alone_.begin(); }
    base::Time end() const override { return alone_.end(); }
    std::optional<SignalSample> at(base::Time time) const override { return alone_.at(time); }
    std::vector<ReceivedAircraft> traffic(base::Time time) const override {
        ReceivedAircraft first{2, test_support::traffic_report(0x111111, time)},
            second{31, test_support::traffic_report(0x222222, time)};
        if (time - begin() > base::Duration::seconds(5)) second.report.ground_speed_mps = 5000;
        return {first, second};
    }

private:
    KnownFlight alone_;
};

TEST(FlightLogWriter, OtherAircraftAreReportedOnceASecond) {
    FlightLogSettings settings;
    const auto heard = [&] {
        std::ostringstream stream;
        (void)write_flight_log(FlightAmongOthers(), settings, stream, [](double) { return true; });
        const auto frames = read_back(stream.str());
        for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_GE((frames[i].time - frames[i - 1].time).ns, 125'000) << i;
        const auto assembler = std::make_unique<bus::StateAssembler>(test_support::traffic_bus());
        assembler->feed({frames.data(), frames.size()});
        return assembler->snapshot(kBegin + base::Duration::seconds(10));
    };
    EXPECT_EQ(heard().counters.traffic.reports, 0u) << "a bus that does not carry them";
    settings.bus = test_support::traffic_bus();
    const bus::BusSnapshot snapshot = heard();
    EXPECT_EQ(snapshot.counters.traffic.reports, 10u + 5u);
    EXPECT_EQ(snapshot.counters.traffic.incomplete + snapshot.counters.traffic.repeated + snapshot.counters.traffic.refused, 0u);
    EXPECT_EQ(snapshot.counters.alien, 0u);
    ASSERT_EQ(snapshot.state.traffic.reports.size(), 2u);
    EXPECT_EQ(snapshot.state.traffic.reports[0].address, 0x111111u);
    EXPECT_NEAR((snapshot.state.traffic.reports[0].place.at - kBegin).to_seconds(), 9.083, 1e-3) << "its number is 2";
}

TEST(FlightLogWriter, StampsRiseStrictlyAndKeepToTheBusSpeed) {
    const auto frames = read_back(write(KnownFlight()).text);
    for (std::size_t i = 1; i < frames.size(); ++i) ASSERT_GE((frames[i].time - frames[i - 1].time).ns, 125'000) << i;
}

TEST(FlightLogWriter, IsSilentInAGapAndCountsIt) {
    const Written written = write(KnownFlight());
    EXPECT_NEAR(static_cast<double>(written.counts.silent_ms), 2000, 40);
    for (const bus::CanFrame& frame : read_back(written.text)) {
        const double s = (frame.time - kBegin).to_seconds();
        const bool in_gap = s > 4.01 && s < 6.0;
        EXPECT_TRUE(!in_gap || frame.id == 1830u) << s;
    }
}

TEST(FlightLogWriter, StatesThePhaseEachSecondAndOnChange) {
    EXPECT_EQ(write(KnownFlight()).counts.phase_messages, 11u);  // at 1..10 s, and the change at 2.5 s
}

TEST(FlightLogWriter, EndsEarlyAndWholeWhenAsked) {
    std::ostringstream stream;
    const FlightLogCounts counts =
        write_flight_log(KnownFlight(), FlightLogSettings(), stream, [](double share) { return share < 0.3; });
    EXPECT_TRUE(counts.interrupted);
    const auto frames = read_back(stream.str());
    EXPECT_EQ(frames.size(), counts.frames);
    EXPECT_LT((frames.back().time - kBegin).to_seconds(), 4.1);  // asked once a second
}

TEST(FlightLogWriter, ReportsAStreamThatFails) {
    std::ostringstream stream;
    stream.setstate(std::ios::badbit);
    FlightLogSettings settings;
    settings.name = "x.log";
    test_support::expect_user_error([&] { write_flight_log(KnownFlight(), settings, stream, [](double) { return true; }); },
                                    "x.log: could not be written to its end");
}

TEST(FlightLogWriter, WritesTheSameBytesAgain) { EXPECT_EQ(write(KnownFlight()).text, write(KnownFlight()).text); }

/// Selects another altitude after 5.43 s, and none after 7.21 s.
class SelectingFlight final : public FlightSource {
public:
    base::Time begin() const override { return kBegin; }
    base::Time end() const override { return kBegin + base::Duration::seconds(10); }
    std::optional<SignalSample> at(base::Time time) const override {
        const double s = (time - kBegin).to_seconds();
        SignalSample sample;
        sample[Signal::pitch] = 0;
        if (s < 7.21) sample[Signal::selected_altitude] = s < 5.43 ? 1000 : 2000;
        return sample;
    }
    bool states_guidance() const override { return true; }
};

TEST(FlightLogWriter, WhatIsSelectedIsSentAgainWhenItChanges) {
    FlightLogSettings settings;
    std::ostringstream without;
    (void)write_flight_log(SelectingFlight(), settings, without, [](double) { return true; });
    EXPECT_EQ(without.str().find(" 729#"), std::string::npos) << "this bus carries no guidance";

    settings.bus.guidance.first_identifier = 1832;
    std::ostringstream stream;
    (void)write_flight_log(SelectingFlight(), settings, stream, [](double) { return true; });
    const auto frames = read_back(stream.str());
    const auto assembler = std::make_unique<bus::StateAssembler>(settings.bus);
    std::size_t next = 0;
    const auto state_at = [&](std::int64_t ms) {
        const base::Time now = kBegin + base::Duration::milliseconds(ms);
        for (; next < frames.size() && frames[next].time <= now; ++next) assembler->feed({&frames[next], 1});
        return assembler->snapshot(now).state;
    };
    EXPECT_NEAR(state_at(5420)[Signal::selected_altitude].value_or(0), 1000, 1e-3);
    EXPECT_NEAR(state_at(5460)[Signal::selected_altitude].value_or(0), 2000, 1e-3);
    EXPECT_TRUE(state_at(7200)[Signal::selected_altitude].received());
    EXPECT_FALSE(state_at(7250)[Signal::selected_altitude].received());
    EXPECT_FALSE(state_at(9900)[Signal::selected_altitude].received());
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_log_writer
