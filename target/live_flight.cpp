#include "target/live_flight.hpp"

#include <utility>

#include "bus/canaerospace/identification_service.hpp"

namespace tedavis::target {
namespace {

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
                       bus::LiveClocks clocks, const EventLog& log, PanelExplainer explain)
    : log_(log),
      port_(can),
      can_settings_(settings.can),
      explain_panel_(explain),
      node_(settings.bus.node),
      phase_report_(settings.bus),
      can_(can, settings.can, clocks),
      has_switches_(settings.has_switches),
      switch_config_(settings.switches),
      panel_(std::move(gpio)),
      memory_(settings.bus, has_switches_ ? &switch_config_ : nullptr, {},
              {flight::motion_phase_settings(settings.aircraft.aircraft_class), {}}),
      tracker_(memory_, {can_, &panel_, this}) {}

void LiveFlight::start(base::Time now) {
    memory_.next_step = now;
    if (!has_switches_) return;
    const auto opened = panel_.open(switch_config_, now, base::Duration{});
    if (opened.ok()) return;
    panel_lost_ = true;
    const base::Error why = explain_panel_ != nullptr ? explain_panel_(switch_config_) : base::Error();
    log_.write({(why ? why : opened.error()).message.view()});
}

void LiveFlight::receive(base::Span<const bus::CanFrame> frames) {
    for (const bus::CanFrame& frame : frames) {
        if (frame.kind != bus::FrameKind::error) latency_.received(frame.time);
        if (!node_.answer_identification) continue;
        const bus::IdentificationAnswer identity = bus::answer_identification(frame, node_);
        // An answer that the kernel does not take is dropped: the requesting node repeats its request.
        if (identity.due) static_cast<void>(can_.send(identity.frame));
    }
}

flight::FrameInput LiveFlight::at(base::Time now, flight::TerrainHeights& heights) {
    const flight::FrameInput input = tracker_.advance_to(now, heights);
    report_bus(now);
    report_switches();
    report_phase(input.phase, now);
    return input;
}

/// A message that the kernel does not take is due again in the next frame.
void LiveFlight::report_phase(const flight::PhaseStatus& phase, base::Time now) {
    const std::optional<bus::CanFrame> message = phase_report_.due(phase, now);
    if (message && can_.send(*message)) phase_report_.sent(phase, now);
}

/// A controller at its limit turns bus-off and back many times a second: at most one line a second, the newest.
void LiveFlight::report_bus(base::Time now) {
    const bus::SourceHealth health = can_.health();
    if (bus_reported_ && (health == reported_health_ || now - bus_reported_at_ < kReportSpacing)) return;
    bus_reported_ = true;
    bus_reported_at_ = now;
    reported_health_ = health;
    write_bus_fault(health);
}

/// The system knows more of a silent interface than its socket says.
void LiveFlight::write_bus_fault(bus::SourceHealth health) {
    const bool is_failed = health == bus::SourceHealth::failed;
    const bool is_silent = is_failed || health == bus::SourceHealth::link_down || health == bus::SourceHealth::bus_off;
    if (const auto why = is_silent ? port_.explain(can_settings_) : bus::SocketFaultText(); !why.empty())
        return log_.write({why.view()});
    if (is_failed) return log_.write({can_.last_fault()});
    log_.write(
        {"CAN interface '", can_settings_.interface_name.view(), "': ", description(health, can_.statistics().reopened > 0)});
}

void LiveFlight::report_switches() {
    if (!has_switches_ || panel_lost_ || panel_.health() != bus::SourceHealth::failed) return;
    panel_lost_ = true;
    log_.write({"phase switches: the GPIO lines do not answer any more; the phase comes from bus and motion until a restart"});
}

}  // namespace tedavis::target
