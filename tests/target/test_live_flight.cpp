#include "target/live_flight.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "bus/canaerospace/message_encoder.hpp"
#include "render_core/display/display.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/flights/sent_traffic.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_live_flight {
namespace {

using base::SignalState;
using flight::Signal;
using ::testing::HasSubstr;

constexpr std::int64_t kMs = 1'000'000;

/// A panel of seven lines, all levels in one word; `dead` hardware does not answer.
struct FakePanel {
    std::uint32_t levels = 1;  // GROUND
    bool dead = false;
    bool absent = false;
};
class FakeLines final : public bus::GpioLines {
public:
    explicit FakeLines(FakePanel& panel) : panel_(panel) {}
    bool request(const bus::SwitchConfig&, base::Error& error) override {
        error.message = "switch line 'panel.GROUND': there is no such chip";
        return !panel_.absent;
    }
    void release() override {}
    bool read_level(std::size_t line, bool& level) override {
        level = (panel_.levels >> line & 1u) != 0;
        return !panel_.dead;
    }
    Burst read_edges(std::size_t line, base::Span<bus::SwitchEdge> out) override {
        const bool level = (panel_.levels >> line & 1u) != 0, before = (reported_ >> line & 1u) != 0;
        if (panel_.dead) return {0, false, true};
        if (level == before) return {};
        out[0] = {FakeClock::monotonic(), static_cast<std::uint8_t>(line), level};
        reported_ ^= 1u << line;
        return {1, false, false};
    }

private:
    FakePanel& panel_;
    std::uint32_t reported_ = panel_.levels;
};

struct LiveFlightTest : testing::Test {
    void SetUp() override { FakeClock::reset(); }
    LiveFlight& start(bool with_panel = false) {
        settings = board_settings();
        settings.has_switches = with_panel;
        if (with_panel) {
            const std::string path = test_support::source_dir() + "/configs/switches/one_hot.toml";
            std::string text;
            {
                std::FILE* file = std::fopen(path.c_str(), "rb");
                char part[4096];
                for (std::size_t n = 1; n > 0;) text.append(part, n = std::fread(part, 1, sizeof part, file));
                std::fclose(file);
            }
            settings.switches = bus::load_switch_config(text, path).value();
        }
        flight.emplace(settings, port, std::make_unique<FakeLines>(panel), FakeClock::clocks().live, log);
        flight->start(FakeClock::monotonic());
        return *flight;
    }
    flight::FrameInput step(std::int64_t ms = 33) {
        FakeClock::now_ns += ms * kMs;
        return flight->at(FakeClock::monotonic(), display.planner());
    }
    BoardSettings settings;
    PairPort port;
    FakePanel panel;
    LogLines lines;
    EventLog log = lines.log();
    display::Display display;  // never started: no terrain
    std::optional<LiveFlight> flight;
};

TEST_F(LiveFlightTest, TheRecordedFlightArrivesAsItWasFlown) {
    start();
    (void)step();
    EmbeddedFlight recorded;
    flight::FrameInput instant;
    while (!recorded.over()) {
        recorded.send_due(port);
        instant = step();
    }
    const base::Time now = FakeClock::monotonic();
    EXPECT_EQ(flight->counters(now).frames, recorded.size());
    EXPECT_EQ(flight->counters(now).decoded, recorded.size());
    EXPECT_EQ(instant.state.own_ship.state, SignalState::valid);
    // Where the aircraft was up to 66 ms earlier, at 100 m/s.
    EXPECT_NEAR(base::degrees(instant.state.own_ship.position.latitude_rad), 36.5766, 2e-4);
    EXPECT_NEAR(base::degrees(instant.state[Signal::true_heading].value_or(0)), 20.2955, 0.01);
    EXPECT_EQ(instant.phase.phase, flight::kApproachDescent);
    EXPECT_EQ(instant.phase.source, flight::PhaseSource::can);
    EXPECT_EQ(instant.trail->size(), 2u) << "three seconds of it";
    EXPECT_EQ(instant.state.utc.state, SignalState::valid);
    EXPECT_NEAR((now + instant.state.utc.ahead - base::Time{1'780'322'560'000'000'000}).to_seconds(), 0, 0.1)
        << "the board's clock counts from its start, the log's messages say 14:02:37 to :40";
    EXPECT_EQ(flight->bus_health(), bus::SourceHealth::running);
    EXPECT_EQ(lines.str(),
              "tedavis-display: CAN interface 'can9': open, nothing received yet\n"
              "tedavis-display: CAN interface 'can9': receiving\n");
}

TEST_F(LiveFlightTest, OtherAircraftAreHeardAndForgotten) {
    start();
    (void)step();
    for (const bus::CanFrame& frame : test_support::traffic_frames(test_support::traffic_report(0x3C6444, FakeClock::monotonic()),
                                                                   0, 0, FakeClock::monotonic()))
        ASSERT_TRUE(port.deliver(frame));
    const flight::Traffic heard = step().state.traffic;
    ASSERT_EQ(heard.reports.size(), 1u);
    EXPECT_EQ(heard.reports[0].callsign.view(), "TDV417");
    EXPECT_LE((FakeClock::monotonic() - heard.reports[0].place.at).to_seconds(), 0.04) << "by the board's own clock";
    EXPECT_EQ(step(59'000).state.traffic.reports.size(), 1u);
    EXPECT_EQ(step(2000).state.traffic.reports.size(), 0u);
}

TEST_F(LiveFlightTest, SilenceMakesEverythingStaleThenLost) {
    start();
    (void)step();
    EmbeddedFlight recorded;
    while (!recorded.over()) {
        recorded.send_due(port);
        (void)step();
    }
    const flight::FrameInput later = step(500);
    EXPECT_EQ(later.state.state_of(Signal::pitch, FakeClock::monotonic()), SignalState::stale);
    EXPECT_EQ(later.state.own_ship.state, SignalState::stale);
    const flight::FrameInput last = step(20'000);
    EXPECT_EQ(last.state.state_of(Signal::pitch, FakeClock::monotonic()), SignalState::lost);
    EXPECT_NE(last.state.own_ship.state, SignalState::valid);
}

TEST_F(LiveFlightTest, AMissingBusIsReportedOnceAndTakenWhenItAppears) {
    port.missing = true;
    start();
    for (int n = 0; n < 100; ++n) (void)step();
    EXPECT_EQ(lines.str(), "tedavis-display: CAN interface 'can9': there is no such interface\n");
    EXPECT_GE(port.attempts, 3);
    EXPECT_LE(port.attempts, 4) << "at most one a second";
    port.missing = false;
    for (int n = 0; n < 40; ++n) (void)step();
    EXPECT_EQ(flight->bus_health(), bus::SourceHealth::idle);
    EXPECT_THAT(lines.str(), HasSubstr("open, nothing received yet"));
    EXPECT_EQ(lines.lines(), 2u);
}

TEST_F(LiveFlightTest, BusOffAndLostSocketsAreReportedAtMostOnceASecond) {
    constexpr std::uint32_t kBusOff = 0x40, kRestarted = 0x100;
    start();
    (void)step();
    for (int n = 0; n < 90; ++n) {  // three seconds of a controller that comes and goes
        port.deliver_error(n % 2 == 0 ? kBusOff : kRestarted);
        (void)step();
    }
    EXPECT_THAT(lines.str(), HasSubstr("the controller is bus-off"));
    EXPECT_LE(lines.lines(), 5u);
    port.hang_up();
    port.missing = true;
    (void)step(2000);
    EXPECT_EQ(flight->bus_health(), bus::SourceHealth::failed);
    EXPECT_THAT(lines.str(), HasSubstr("there is no such interface"));
    port.missing = false;
    (void)step(2000);
    EXPECT_THAT(lines.str(), HasSubstr("open again"));
    EXPECT_EQ(flight->bus_statistics().reopened, 1u);
}

TEST_F(LiveFlightTest, WhatTheSystemKnowsOfASilentBusIsSaidInPlaceOfWhatTheSocketSays) {
    port.explanation = bus::SocketFaultText("CAN interface 'can9': is bus-off and stays so; do this");
    start();
    (void)step();
    EXPECT_THAT(lines.str(), testing::Not(HasSubstr("do this"))) << "a bus that may come is no fault";
    port.deliver_error(0x40);
    (void)step(2000);
    EXPECT_THAT(lines.str(), HasSubstr("tedavis-display: CAN interface 'can9': is bus-off and stays so; do this\n"));
    EXPECT_THAT(lines.str(), testing::Not(HasSubstr("the controller is bus-off")));
}

TEST_F(LiveFlightTest, APanelThatCannotBeOpenedIsExplainedWhereSomebodyCan) {
    panel.absent = true;
    start(true);
    const auto log_with = [this](PanelExplainer explain) {
        lines.text.clear();
        flight.emplace(settings, port, std::make_unique<FakeLines>(panel), FakeClock::clocks().live, log, explain);
        flight->start(FakeClock::monotonic());
        return lines.str();
    };
    EXPECT_EQ(log_with([](const bus::SwitchConfig&) { return base::make_error("used by another"); }),
              "tedavis-display: used by another\n");
    EXPECT_THAT(log_with([](const bus::SwitchConfig&) { return base::Error(); }), HasSubstr("there is no such chip"));
}

TEST_F(LiveFlightTest, ThePanelStatesThePhase) {
    start(true);
    EXPECT_EQ(step().phase.phase.scenario, flight::Scenario::ground);
    panel.levels = 4;  // CRUISE
    for (int n = 0; n < 20; ++n) (void)step();
    const flight::PhaseStatus cruise = step().phase;
    EXPECT_EQ(cruise.phase.scenario, flight::Scenario::cruise);
    EXPECT_EQ(cruise.source, flight::PhaseSource::switches);
    EXPECT_FALSE(cruise.switch_fault);
    panel.levels = 6;  // two lines at once are impossible
    for (int n = 0; n < 20; ++n) (void)step();
    EXPECT_TRUE(step().phase.switch_fault);
    EXPECT_EQ(step().phase.phase.scenario, flight::Scenario::cruise) << "the last valid one is kept";
}

TEST_F(LiveFlightTest, APanelThatFailsRaisesItsFlagAndIsReportedOnce) {
    start(true);
    (void)step();
    panel.dead = true;
    for (int n = 0; n < 50; ++n) (void)step();
    EXPECT_TRUE(step().phase.switch_fault);
    EXPECT_NE(step().phase.source, flight::PhaseSource::switches);
    EXPECT_THAT(lines.str(), HasSubstr("the GPIO lines do not answer any more"));
    EXPECT_EQ(lines.lines(), 2u) << lines.str();
}

TEST_F(LiveFlightTest, APanelThatIsNotThereIsAFlagToo) {
    panel.absent = true;
    start(true);
    EXPECT_TRUE(step().phase.switch_fault);
    EXPECT_THAT(lines.str(), HasSubstr("switch line 'panel.GROUND': there is no such chip"));
    flight.emplace(settings, port, nullptr, FakeClock::clocks().live, log);
    flight->start(FakeClock::monotonic());
    EXPECT_TRUE(step().phase.switch_fault);
    EXPECT_THAT(lines.str(), HasSubstr("built without libgpiod"));
}

TEST_F(LiveFlightTest, IdentificationIsAnsweredOnlyWhereTheBusFileSaysSo) {
    bus::CanFrame request;
    request.id = 128;
    request.length = 4;  // node 0 (all), NODATA, service 0, message code 0
    bus::CanFrame reply;
    for (const bool answers : {false, true}) {
        settings = board_settings();
        settings.bus.node.answer_identification = answers;
        flight.emplace(settings, port, nullptr, FakeClock::clocks().live, log);
        flight->start(FakeClock::monotonic());
        (void)step();
        ASSERT_TRUE(port.deliver(request));
        (void)step();
        EXPECT_EQ(port.receive(reply), answers);
    }
    EXPECT_EQ(reply.id, 129u);
    EXPECT_EQ(reply.data[0], settings.bus.node.node);
}

TEST_F(LiveFlightTest, ThePhaseIsReportedOnTheBusOnlyWhereTheBusFileSaysSo) {
    bus::CanFrame message;
    for (const std::uint16_t identifier : {0, 1853}) {
        settings = board_settings();
        settings.bus.phase.report_identifier = identifier;
        flight.emplace(settings, port, nullptr, FakeClock::clocks().live, log);
        flight->start(FakeClock::monotonic());
        (void)step();
        EXPECT_EQ(port.receive(message), identifier != 0);
    }
    EXPECT_EQ(message.id, 1853u);
    EXPECT_EQ(message.data[4], flight::FlightPhase{}.code());
    EXPECT_FALSE(port.receive(message)) << "it is sent once, until something changes";
}

TEST_F(LiveFlightTest, TheReportedPhaseIsTheOneThatTheDisplayHas) {
    settings = board_settings();
    settings.bus.phase.report_identifier = 1853;
    flight.emplace(settings, port, nullptr, FakeClock::clocks().live, log);
    flight->start(FakeClock::monotonic());
    (void)step();
    EmbeddedFlight recorded;
    flight::FrameInput instant;
    bus::CanFrame message, last;
    while (!recorded.over()) {
        recorded.send_due(port);
        instant = step();
        while (port.receive(message)) last = message;
    }
    EXPECT_EQ(instant.phase.phase, flight::kApproachDescent);
    EXPECT_EQ(last.id, 1853u);
    EXPECT_EQ(last.data[4], flight::kApproachDescent.code());
    EXPECT_EQ(last.data[5], static_cast<int>(flight::PhaseSource::can));
}

TEST_F(LiveFlightTest, AProgramThatWasHaltedGoesOnAtOnce) {
    start();
    (void)step();
    FakeClock::now_ns += 3'600'000 * kMs;
    for (int n = 0; n < 3; ++n) (void)step();
    ASSERT_TRUE(port.deliver(bus::CanFrame{}));
    (void)step();
    EXPECT_EQ(flight->counters(FakeClock::monotonic()).frames, 1u);
}

}  // namespace
}  // namespace tedavis::target::test_live_flight
