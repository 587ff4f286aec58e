#include "bus/tracker/flight_tracker.hpp"

#include <cmath>

namespace tedavis::bus {
namespace {

constexpr std::size_t kEdgesAtOnce = 64;
constexpr base::Duration kStep = flight::PhaseMonitor::kStep;

void ask_for_height(flight::AircraftState& aircraft, base::Time now, flight::TerrainHeights& heights) {
    aircraft[flight::Signal::height_above_terrain] = heights.height_above_terrain(aircraft.own_ship, now);
}

/// An old angle counts as long as it is shown.
double shown_angle_rad(const flight::AircraftState& aircraft, flight::Signal angle, base::Time now) {
    const base::SignalState state = aircraft.state_of(angle, now);
    const bool is_shown = state == base::SignalState::valid || state == base::SignalState::stale;
    return is_shown ? aircraft[angle].value_or(0) : std::nan("");
}

/// How long a message of the phase counts is the bus file's to say.
flight::PhaseSettings on_bus(const BusSettings& bus, flight::PhaseSettings phases) {
    phases.arbiter.can_timeout = bus.phase.timeout;
    return phases;
}

}  // namespace

TrackerMemory::TrackerMemory(const BusSettings& settings, const SwitchConfig* panel, base::Time first_step,
                             const flight::PhaseSettings& phases)
    : assembler(settings), monitor(on_bus(settings, phases)), next_step(first_step) {
    if (panel != nullptr) switches.emplace(*panel);
}

flight::FrameInput FlightTracker::advance_to(base::Time now, flight::TerrainHeights& heights) {
    if (now - memory_.next_step > base::Duration{kStep.ns * kMaxSteps}) memory_.next_step = now;
    for (int n = 0; n <= kMaxSteps && memory_.next_step <= now; ++n) step(heights);
    return input_at(now, heights);
}

void FlightTracker::step(flight::TerrainHeights& heights) {
    const base::Time now = memory_.next_step;
    read_until(now);
    BusSnapshot snapshot = memory_.assembler.snapshot(now);
    flight::AircraftState& aircraft = snapshot.state;
    ask_for_height(aircraft, now, heights);
    memory_.monitor.step(aircraft, phase_inputs(snapshot.phase_status, now), now);
    memory_.trail.step(aircraft, now);
    memory_.airspeed.step(aircraft, now);
    memory_.excursion.step(shown_angle_rad(aircraft, flight::Signal::pitch, now),
                           shown_angle_rad(aircraft, flight::Signal::roll, now));
    memory_.next_step = now + kStep;
}

void FlightTracker::skip_steps_before(base::Time time) {
    if (time <= memory_.next_step) return;
    const std::int64_t skipped = ((time - memory_.next_step).ns + kStep.ns - 1) / kStep.ns;
    memory_.next_step = memory_.next_step + base::Duration{kStep.ns * skipped};
}

flight::FrameInput FlightTracker::input_at(base::Time now, flight::TerrainHeights& heights) {
    read_until(now);
    const BusSnapshot snapshot = memory_.assembler.snapshot(now);
    flight::FrameInput input{snapshot.state, memory_.monitor.status(), now, &memory_.trail};
    input.legend = panel_asks_for_legend(now) ? flight::LegendShow::whole : snapshot.legend;
    ask_for_height(input.state, now, heights);
    input.state[flight::Signal::airspeed_rate] = memory_.airspeed.rate();
    input.state.excursion = memory_.excursion;
    return input;
}

void FlightTracker::read_until(base::Time time) {
    std::size_t count = kFramesAtOnce;
    for (std::uint32_t n = 0; n < ports_.max_batches && count == kFramesAtOnce; ++n) {
        count = ports_.can.read(time, base::Span<CanFrame>(batch_));
        memory_.assembler.feed({batch_, count});
        if (ports_.listener != nullptr) ports_.listener->receive({batch_, count});
    }
    memory_.assembler.record_dropped(ports_.can.statistics().dropped);
    read_switches(time);
}

void FlightTracker::read_switches(base::Time time) {
    if (ports_.panel == nullptr || !memory_.switches) return;
    SwitchEdge edges[kEdgesAtOnce];
    std::size_t count = kEdgesAtOnce;
    for (std::uint32_t n = 0; n < ports_.max_batches && count == kEdgesAtOnce; ++n) {
        count = ports_.panel->read(time, base::Span<SwitchEdge>(edges));
        for (std::size_t k = 0; k < count; ++k) memory_.switches->add(edges[k]);
    }
}

/// A panel that fails asks for nothing.
bool FlightTracker::panel_asks_for_legend(base::Time time) const {
    if (ports_.panel == nullptr || !memory_.switches || ports_.panel->health() == SourceHealth::failed) return false;
    return memory_.switches->config().asks_for_legend(memory_.switches->status(time).levels);
}

flight::PhaseInputs FlightTracker::phase_inputs(const PhaseMessage& stated, base::Time time) const {
    flight::PhaseInputs inputs;
    inputs.can = stated.phase;
    if (ports_.panel == nullptr || !memory_.switches) return inputs;
    inputs.switch_fault = ports_.panel->health() == SourceHealth::failed;
    if (inputs.switch_fault) return inputs;
    const SwitchPhase panel = memory_.switches->status(time);
    inputs.switches = panel.statement;
    inputs.switch_fault = panel.fault;
    return inputs;
}

}  // namespace tedavis::bus
