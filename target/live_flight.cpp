#include "target/live_flight.hpp"

#include <utility>

#include "bus/canaerospace/identification_service.hpp"

namespace tedavis::target {
namespace {

constexpr std::size_t kFramesAtOnce = 256;
constexpr int kMaxBatches = 64;  // more than a frame's worth of the fastest bus; the rest waits for the next step
constexpr int kMaxSteps = 100;   // after a longer pause of the program the grid starts anew
constexpr std::size_t kEdgesAtOnce = 64;
constexpr base::Duration kReportSpacing = base::Duration::seconds(1);

std::string_view description(bus::SourceHealth health, bool opened_again) {
    switch (health) {
        case bus::SourceHealth::running: return "receiving";
        case bus::SourceHealth::idle: return opened_again ? "open again, nothing received yet" : "open, nothing received yet";
        case bus::SourceHealth::link_down: return "the link is down; it is used again when it is up";
        case bus::SourceHealth::bus_off: return "the controller is bus-off; set restart-ms with `ip link` or restart it";
        case bus::SourceHealth::ended:
        case bus::SourceHealth::failed: break;
    }
    return "not open; it is tried again";
}

}  // namespace

LiveFlight::LiveFlight(const BoardSettings& settings, bus::CanSocketPort& can, std::unique_ptr<bus::GpioLines> gpio,
                       bus::LiveClocks clocks, const EventLog& log)
    : log_(log),
      interface_name_(settings.can.interface_name),
      node_(settings.bus.node),
      can_(can, settings.can, clocks),
      assembler_(settings.bus),
      has_switches_(settings.has_switches),
      switch_config_(settings.switches),
      panel_(std::move(gpio)) {}

void LiveFlight::start(base::Time now) {
    next_step_ = now;
    if (!has_switches_) return;
    switches_.emplace(switch_config_);
    const auto opened = panel_.open(switch_config_, now, base::Duration{});
    if (opened.ok()) return;
    panel_lost_ = true;
    log_.write({opened.error().message.view()});
}

void LiveFlight::feed_until(base::Time time) {
    bus::CanFrame batch[kFramesAtOnce];
    std::size_t count = kFramesAtOnce;
    for (int n = 0; n < kMaxBatches && count == kFramesAtOnce; ++n) {
        count = can_.read(time, base::Span<bus::CanFrame>(batch));
        assembler_.feed({batch, count});
        if (node_.answer_identification) answer({batch, count});
    }
    assembler_.note_dropped(can_.statistics().dropped);
    feed_switches(time);
}

void LiveFlight::feed_switches(base::Time time) {
    if (!switches_ || panel_lost_) return;
    bus::SwitchEdge edges[kEdgesAtOnce];
    const std::size_t count = panel_.read(time, base::Span<bus::SwitchEdge>(edges));
    for (std::size_t n = 0; n < count; ++n) switches_->add(edges[n]);
}

void LiveFlight::answer(base::Span<const bus::CanFrame> frames) {
    for (const bus::CanFrame& frame : frames) {
        const bus::IdentificationAnswer identity = bus::answer_identification(frame, node_);
        // An answer that the kernel does not take is asked for again.
        if (identity.due) static_cast<void>(can_.send(identity.frame));
    }
}

void LiveFlight::step_phase(base::Time time, display::Display& display) {
    const bus::BusSnapshot snapshot = assembler_.snapshot(time);
    flight::AircraftState aircraft = snapshot.state;
    aircraft[flight::Signal::height_above_terrain] = display.height_above_terrain(aircraft.own_ship, time);
    flight::PhaseInputs inputs;
    inputs.can = snapshot.phase_status.phase;
    inputs.switch_fault = panel_lost_;
    if (switches_ && !panel_lost_) {
        const bus::SwitchPhase panel = switches_->status(time);
        inputs.switches = panel.statement;
        inputs.switch_fault = panel.fault;
    }
    monitor_.step(aircraft, inputs, time);
    way_.step(aircraft, time);
}

LiveFlight::Instant LiveFlight::at(base::Time now, display::Display& display) {
    constexpr base::Duration kStep = display::PhaseMonitor::kStep;
    if (now - next_step_ > base::Duration{kStep.ns * kMaxSteps}) next_step_ = now;
    for (int n = 0; n <= kMaxSteps && next_step_ <= now; ++n) {
        feed_until(next_step_);
        step_phase(next_step_, display);
        next_step_ = next_step_ + kStep;
    }
    feed_until(now);
    report_bus(now);
    report_switches();
    Instant instant;
    instant.aircraft = assembler_.snapshot(now).state;
    instant.aircraft[flight::Signal::height_above_terrain] = display.height_above_terrain(instant.aircraft.own_ship, now);
    instant.phase = monitor_.status();
    return instant;
}

/// A controller at its limit turns bus-off and back many times a second: at most one line a second, the newest.
void LiveFlight::report_bus(base::Time now) {
    const bus::SourceHealth health = can_.health();
    if (bus_reported_ && (health == reported_health_ || now - bus_reported_at_ < kReportSpacing)) return;
    bus_reported_ = true;
    bus_reported_at_ = now;
    reported_health_ = health;
    if (health == bus::SourceHealth::failed)
        log_.write({can_.last_fault()});
    else
        log_.write({"CAN interface '", interface_name_.view(), "': ", description(health, can_.statistics().reopened > 0)});
}

void LiveFlight::report_switches() {
    if (!switches_ || panel_lost_ || panel_.health() != bus::SourceHealth::failed) return;
    panel_lost_ = true;
    log_.write({"phase switches: the GPIO lines do not answer any more; the phase comes from bus and motion until a restart"});
}

}  // namespace tedavis::target
