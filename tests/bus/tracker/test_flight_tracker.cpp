#include "bus/tracker/flight_tracker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "bus/canaerospace/message_encoder.hpp"
#include "render_core/base/units.hpp"
#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_flight_tracker {
namespace {

using base::Duration;
using flight::PhaseSource;
using flight::Scenario;
using flight::Signal;

constexpr std::int64_t kEnd_ms = 60'000;

/// A recording, read from its start.
struct Recording {
    std::vector<CanFrame> frames;
    std::vector<SwitchEdge> edges;
};

/// Twenty fixes a second of a cruise at 70 m/s, to the north; it climbs in the middle, and its bus says `approach` at the end.
Recording recorded_flight() {
    Recording recording;
    MessageEncoder encoder(BusSettings(), 9);
    CanFrame out[2];
    const auto put = [&](std::size_t count) { recording.frames.insert(recording.frames.end(), out, out + count); };
    for (std::int64_t ms = 7; ms < kEnd_ms; ms += 50) {
        const double t = static_cast<double>(ms) / 1000, climb = ms > 20'000 && ms < 40'000 ? 5 : 0;
        put(encoder.encode(1036, 0.8 + 70 * t / 6'371'000, DataType::double_high, at_ms(ms), out));
        put(encoder.encode(1037, 0.17, DataType::double_high, at_ms(ms), out));
        put(encoder.encode(1038, 3000, DataType::float32, at_ms(ms), out));
        put(encoder.encode(1039, 70, DataType::float32, at_ms(ms), out));
        put(encoder.encode(1040, 0, DataType::float32, at_ms(ms), out));
        put(encoder.encode(314, climb, DataType::float32, at_ms(ms), out));
        put(encoder.encode(315, 70 + 0.25 * t, DataType::float32, at_ms(ms), out));
        if (ms > 50'000) put(encoder.encode_phase(flight::kApproachFinal, PhaseOrigin::pilot, 100, true, at_ms(ms), out));
    }
    return recording;
}

class RecordedCan final : public CanSource {
public:
    explicit RecordedCan(const std::vector<CanFrame>& frames) : frames_(frames) {}
    std::size_t read(base::Time until, base::Span<CanFrame> out) override {
        std::size_t count = 0;
        while (count < out.size() && next < frames_.size() && frames_[next].time <= until) out[count++] = frames_[next++];
        return count;
    }
    [[nodiscard]] SourceHealth health() const override { return SourceHealth::running; }
    [[nodiscard]] const SourceStatistics& statistics() const override { return statistics_; }

    std::size_t next = 0;

private:
    const std::vector<CanFrame>& frames_;
    SourceStatistics statistics_;
};

class RecordedPanel final : public SwitchSource {
public:
    explicit RecordedPanel(const std::vector<SwitchEdge>& edges) : edges_(edges) {}
    std::size_t read(base::Time until, base::Span<SwitchEdge> out) override {
        std::size_t count = 0;
        while (count < out.size() && next < edges_.size() && edges_[next].time <= until) out[count++] = edges_[next++];
        return count;
    }
    [[nodiscard]] SourceHealth health() const override { return is_lost ? SourceHealth::failed : SourceHealth::running; }
    [[nodiscard]] const SwitchStatistics& statistics() const override { return statistics_; }

    std::size_t next = 0;
    bool is_lost = false;

private:
    const std::vector<SwitchEdge>& edges_;
    SwitchStatistics statistics_;
};

/// Ground as far below as it is told, and how often it was asked for.
class Ground final : public flight::TerrainHeights {
public:
    explicit Ground(double below_m) : below_m_(below_m) {}
    base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate& own_ship, base::Time now) override {
        asked.push_back(now);
        if (own_ship.state != base::SignalState::valid) return {};
        return {below_m_, now};
    }
    std::vector<base::Time> asked;

private:
    double below_m_;
};

struct Counter final : FrameListener {
    void receive(base::Span<const CanFrame> frames) override { received += frames.size(); }
    std::size_t received = 0;
};

/// A tracker and all that it reads.
struct Tracked {
    explicit Tracked(const Recording& recording, double below_m = 2500, bool has_panel = true, std::uint32_t max_batches = 64,
                     const BusSettings& bus = BusSettings(), const SwitchConfig& lines = three_lines())
        : config(lines),
          can(recording.frames),
          panel(recording.edges),
          ground(below_m),
          memory(std::make_unique<TrackerMemory>(bus, has_panel ? &config : nullptr, at_ms(0))),
          tracker(*memory, {can, &panel, &counter, max_batches}) {}

    flight::FrameInput to(std::int64_t ms) { return tracker.advance_to(at_ms(ms), ground); }
    /// To a time, a frame each `step_ms`.
    flight::FrameInput fly(std::int64_t from_ms, std::int64_t to_ms, std::int64_t step_ms) {
        for (std::int64_t ms = from_ms; ms < to_ms; ms += step_ms) (void)to(ms);
        return to(to_ms);
    }

    SwitchConfig config;
    RecordedCan can;
    RecordedPanel panel;
    Ground ground;
    Counter counter;
    std::unique_ptr<TrackerMemory> memory;
    FlightTracker tracker;
};

BusSettings bus_with_legend() {
    BusSettings settings;
    settings.display.legend_identifier = 1852;
    return settings;
}

/// What two inputs must have alike to be of one flight, every number exactly.
std::string text_of(const flight::FrameInput& input) {
    std::string text = std::to_string(input.time.ns) + " " + flight::sub_phase_name(input.phase.phase) + " " +
                       flight::scenario_name(input.phase.phase) + " by " + flight::to_string(input.phase.source) + " since " +
                       std::to_string(input.phase.presented_since.ns) + (input.phase.switch_fault ? " fault" : "") +
                       (input.legend ? " legend " + std::string(name_of(*input.legend)) : "");
    const auto add = [&text](double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        text += " " + std::to_string(bits);
    };
    for (const base::Stamped<double>& signal : input.state.signals) add(signal.value_or(-1));
    add(input.state.own_ship.position.latitude_rad);
    for (std::size_t n = 0; n < input.trail->size(); ++n) {
        add((*input.trail)[n].latitude_rad);
        text += " at " + std::to_string((*input.trail)[n].at.ns);
    }
    return text;
}

TEST(FlightTracker, AnInputDependsOnItsTimeAndNotOnWhoAskedBefore) {
    Recording recording = recorded_flight();
    recording.edges = {edge(0, 0, false), edge(0, 1, true), edge(0, 2, false), edge(30'005, 1, false), edge(30'006, 2, true)};
    Tracked rare(recording), often(recording), late(recording);
    for (std::int64_t second = 1; second < 60; ++second) {
        const std::string expected = text_of(rare.to(1000 * second));
        EXPECT_EQ(text_of(often.fly(1000 * second - 999, 1000 * second, 7)), expected) << second;
        // The control: a flight that is played a millisecond later is another one.
        EXPECT_NE(text_of(late.to(1000 * second + 1)), expected) << second;
    }
}

TEST(FlightTracker, ThePhaseIsThatOfSwitchesThenOfTheBusThenOfMotion) {
    Recording recording = recorded_flight();
    const flight::FrameInput by_motion = Tracked(recording, 2500, false).fly(0, 49'000, 1000);
    EXPECT_EQ(by_motion.phase.source, PhaseSource::motion);
    EXPECT_FALSE(by_motion.phase.switch_fault) << "there is no panel";
    const flight::FrameInput by_bus = Tracked(recording, 2500, false).fly(0, 59'000, 1000);
    EXPECT_EQ(by_bus.phase.source, PhaseSource::can);
    EXPECT_EQ(by_bus.phase.phase, flight::kApproachFinal);
    recording.edges = {edge(0, 0, false), edge(0, 1, true), edge(0, 2, false)};
    const flight::FrameInput by_switch = Tracked(recording).fly(0, 59'000, 1000);
    EXPECT_EQ(by_switch.phase.source, PhaseSource::switches);
    EXPECT_EQ(by_switch.phase.phase.scenario, Scenario::cruise);
}

/// The last message comes at 59.957 s.
TEST(FlightTracker, AMessageOfThePhaseCountsAsLongAsTheBusFileSays) {
    const Recording recording = recorded_flight();
    const auto source_at = [&](double timeout_s, std::int64_t ms) {
        BusSettings bus;
        bus.phase.timeout = Duration::from_seconds(timeout_s);
        return Tracked(recording, 2500, false, 64, bus).fly(0, ms, 500).phase.source;
    };
    for (const double timeout_s : {1.0, 3.0, 6.0}) {
        const auto end_ms = static_cast<std::int64_t>(59'957 + 1000 * timeout_s);
        EXPECT_EQ(source_at(timeout_s, end_ms - 60), PhaseSource::can) << timeout_s;
        EXPECT_NE(source_at(timeout_s, end_ms + 60), PhaseSource::can) << timeout_s;
    }
}

/// A request for the whole legend at 10 s, for none at 30 s, and a line of the panel that is active from 20 s to 40 s.
Recording flight_with_legends() {
    Recording recording = recorded_flight();
    MessageEncoder encoder(bus_with_legend(), 9);
    const auto ask = [&](flight::LegendShow show, std::int64_t ms) {
        CanFrame frame;
        EXPECT_EQ(encoder.encode_legend_request(show, at_ms(ms), {&frame, 1}), 1u);
        const auto later = std::find_if(recording.frames.begin(), recording.frames.end(),
                                        [&](const CanFrame& other) { return other.time > frame.time; });
        recording.frames.insert(later, frame);
    };
    ask(flight::LegendShow::key, 10'000);
    ask(flight::LegendShow::none, 30'000);
    recording.edges = {edge(0, 0, false), edge(0, 1, true),      edge(0, 2, false),
                       edge(0, 3, false), edge(20'000, 3, true), edge(40'000, 3, false)};
    return recording;
}

TEST(FlightTracker, TheLegendIsThatOfThePanelThenOfTheBus) {
    using flight::LegendShow;
    const Recording recording = flight_with_legends();
    Tracked flight(recording, 2500, true, 64, bus_with_legend(), three_lines_and_legend());
    EXPECT_FALSE(flight.fly(0, 9'000, 1000).legend) << "nobody asks";
    EXPECT_EQ(flight.fly(9'000, 15'000, 1000).legend, LegendShow::key);
    EXPECT_EQ(flight.fly(15'000, 25'000, 1000).legend, LegendShow::whole);
    EXPECT_EQ(flight.fly(25'000, 35'000, 1000).legend, LegendShow::whole) << "the panel comes first";
    flight.panel.is_lost = true;
    EXPECT_EQ(flight.fly(35'000, 36'000, 1000).legend, LegendShow::none) << "a panel that fails asks for nothing";
    flight.panel.is_lost = false;
    EXPECT_EQ(flight.fly(36'000, 50'000, 1000).legend, LegendShow::none) << "the last request holds";
    EXPECT_EQ(flight.to(50'000).phase.phase.scenario, Scenario::cruise) << "the line is no part of the pattern";
}

TEST(FlightTracker, ACheckpointCarriesTheLegend) {
    const Recording recording = flight_with_legends();
    Tracked flight(recording, 2500, true, 64, bus_with_legend(), three_lines_and_legend()),
        copy(recording, 2500, true, 64, bus_with_legend(), three_lines_and_legend()),
        other(recording, 2500, true, 64, bus_with_legend(), three_lines_and_legend());
    (void)flight.fly(0, 15'010, 1000);
    *copy.memory = *flight.memory;
    copy.can.next = flight.can.next;
    copy.panel.next = flight.panel.next;
    other.can.next = flight.can.next;
    EXPECT_EQ(copy.to(15'020).legend, flight::LegendShow::key);
    EXPECT_FALSE(other.to(15'020).legend) << "the control: without the memory";
    EXPECT_EQ(text_of(copy.fly(15'020, 25'000, 333)), text_of(flight.fly(15'020, 25'000, 1000)));
}

TEST(FlightTracker, APanelThatFailsStatesNoPhaseAndRaisesTheFault) {
    Recording recording = recorded_flight();
    recording.edges = {edge(0, 0, false), edge(0, 1, true), edge(0, 2, false)};
    Tracked flight(recording);
    EXPECT_EQ(flight.fly(0, 55'000, 1000).phase.source, PhaseSource::switches);
    EXPECT_FALSE(flight.to(55'000).phase.switch_fault);
    flight.panel.is_lost = true;
    const flight::FrameInput later = flight.fly(55'000, 59'000, 1000);
    EXPECT_TRUE(later.phase.switch_fault);
    EXPECT_EQ(later.phase.source, PhaseSource::can);
}

TEST(FlightTracker, TheHeightIsAskedForAtEachStepAndReachesStateAndPhase) {
    const Recording recording = recorded_flight();
    Tracked high(recording), low(recording, 3);
    EXPECT_EQ(high.fly(0, 19'000, 1000).state[Signal::height_above_terrain].value_or(0), 2500);
    ASSERT_EQ(high.ground.asked.size(), 951u + 20u) << "steps of 20 ms, both ends, and a frame each second";
    EXPECT_EQ((high.ground.asked[2] - high.ground.asked[1]).ns, Duration::milliseconds(20).ns);
    const flight::FrameInput above = high.fly(20'000, 35'000, 1000), below = low.fly(0, 35'000, 1000);
    EXPECT_EQ(below.state[Signal::height_above_terrain].value_or(0), 3);
    EXPECT_EQ(above.phase.phase.scenario, Scenario::takeoff) << "a climb at 2500 m";
    EXPECT_EQ(below.phase.phase.scenario, Scenario::unknown) << "a climb that flies three metres above the ground";
}

TEST(FlightTracker, TheChangeOfTheAirspeedIsASignalOfTheInput) {
    const Recording recording = recorded_flight();
    Tracked flight(recording);
    EXPECT_FALSE(flight.to(1000).state[Signal::airspeed_rate].received());
    const flight::FrameInput input = flight.fly(1020, 20'000, 20);
    EXPECT_NEAR(input.state[Signal::airspeed_rate].value_or(0), 0.25, 1e-3);
    EXPECT_TRUE(input.state.is_valid(Signal::airspeed_rate, input.time));
}

/// A bank of 70 degrees for a second, else of 20.
Recording steep_turn() {
    Recording recording;
    MessageEncoder encoder(BusSettings(), 9);
    CanFrame out[2];
    for (std::int64_t ms = 0; ms < 4000; ms += 50) {
        const double bank_deg = ms >= 1000 && ms < 2000 ? 70 : ms < 3000 ? 66 : 20;
        const std::size_t count =
            encoder.encode(312, base::radians(bank_deg), DataType::float32, at_ms(ms), base::Span<CanFrame>(out));
        recording.frames.insert(recording.frames.end(), out, out + count);
    }
    return recording;
}

TEST(FlightTracker, RemembersHowFarTheAttitudeWent) {
    const Recording recording = steep_turn();
    Tracked flight(recording);
    EXPECT_NEAR(flight.fly(0, 900, 20).state.excursion.bank_rad, base::radians(66), 1e-6);
    EXPECT_NEAR(flight.fly(920, 2900, 20).state.excursion.bank_rad, base::radians(70), 1e-6) << "66 is within its play";
    Tracked seldom(recording);
    EXPECT_EQ(seldom.fly(0, 2900, 145).state.excursion.bank_rad, flight.fly(2900, 2900, 20).state.excursion.bank_rad)
        << "whatever the rate of frames";
    EXPECT_NEAR(flight.fly(2920, 3900, 20).state.excursion.bank_rad, base::radians(25), 1e-6);
}

TEST(FlightTracker, TheTrailIsOfTheSteps) {
    const Recording recording = recorded_flight();
    Tracked flight(recording);
    const flight::FrameInput input = flight.fly(0, 31'000, 1000);
    EXPECT_EQ(input.trail, &flight.memory->trail);
    EXPECT_EQ(input.trail->size(), 16u) << "a point every two seconds from the first fix on";
    EXPECT_EQ((*input.trail)[0].at.ns, at_ms(20).ns) << "the first step that knows a place";
}

TEST(FlightTracker, ACopyOfItsMemoryGoesOnBitForBit) {
    const Recording recording = recorded_flight();
    Tracked flight(recording), copy(recording), other(recording);
    (void)flight.fly(0, 20'010, 1000);
    *copy.memory = *flight.memory;
    copy.can.next = flight.can.next;
    copy.panel.next = flight.panel.next;
    const std::string expected = text_of(flight.fly(20'010, 45'000, 1000));
    EXPECT_EQ(text_of(copy.fly(20'010, 45'000, 333)), expected);
    // The control: without the memory the same frames give another flight.
    other.can.next = copy.can.next;
    EXPECT_NE(text_of(other.fly(20'010, 45'000, 1000)), expected);
}

TEST(FlightTracker, EveryFrameIsHeardOnceByTheListener) {
    const Recording recording = recorded_flight();
    Tracked flight(recording);
    (void)flight.fly(0, kEnd_ms, 333);
    EXPECT_EQ(flight.counter.received, recording.frames.size());
    EXPECT_EQ(flight.memory->assembler.snapshot(at_ms(kEnd_ms)).counters.frames, recording.frames.size());
}

TEST(FlightTracker, MoreThanAReadingTakesWaitsForTheNext) {
    Recording burst;
    burst.frames.assign(700, CanFrame{});
    for (CanFrame& frame : burst.frames) frame.time = at_ms(1);
    Tracked bounded(burst, 2500, false, 1), whole(burst, 2500, false);
    (void)bounded.tracker.input_at(at_ms(5), bounded.ground);
    (void)whole.tracker.input_at(at_ms(5), whole.ground);
    EXPECT_EQ(bounded.counter.received, 256u);
    EXPECT_EQ(whole.counter.received, 700u);
    (void)bounded.to(40);
    EXPECT_EQ(bounded.counter.received, 700u);
}

TEST(FlightTracker, AfterALongPauseTheGridStartsAnew) {
    const Recording recording = recorded_flight();
    Tracked flight(recording);
    (void)flight.to(2000);
    EXPECT_EQ(flight.ground.asked.size(), 102u) << "as many steps as it catches up with";
    (void)flight.to(3'600'003);
    EXPECT_EQ(flight.ground.asked.size(), 104u) << "one step, and the input";
    EXPECT_EQ(flight.tracker.next_step().ns, at_ms(3'600'023).ns);
}

TEST(FlightTracker, StepsThatAreLeftOutDoNotMoveTheGrid) {
    const Recording recording = recorded_flight();
    Tracked flight(recording);
    flight.tracker.skip_steps_before(at_ms(1001));
    EXPECT_EQ(flight.tracker.next_step().ns, at_ms(1020).ns);
    flight.tracker.skip_steps_before(at_ms(1020));
    flight.tracker.skip_steps_before(at_ms(3));
    EXPECT_EQ(flight.tracker.next_step().ns, at_ms(1020).ns);
    (void)flight.tracker.input_at(at_ms(1500), flight.ground);
    EXPECT_EQ(flight.tracker.next_step().ns, at_ms(1020).ns) << "an input takes no step";
}

}  // namespace
}  // namespace tedavis::bus::test_flight_tracker
