/// The aircraft as the live bus and the live panel state it: the counterpart of a replay's player.
///
/// Bus and panel are read up to each step of the phase monitor's grid, so that the phase passes through the same steps as
/// in a replay. What is missing is never fatal: a bus or a panel that is not there is reported once to the event log, and
/// the display shows its flags. A panel that fails states no phase and raises the switch fault until the next start.
///
/// Thread  one. Memory  inside; nothing after start(). Time  monotonic, from the caller.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "bus/socketcan/socketcan_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "bus/switches/gpiod_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/phase_monitor.hpp"
#include "render_core/flight/flown_way.hpp"
#include "target/board_config.hpp"
#include "target/event_log.hpp"

namespace tedavis::target {

class LiveFlight {
public:
    /// `can`, `clocks` and `log` must outlive it. `gpio` may be null: then a panel that the board file asks for is missing.
    LiveFlight(const BoardSettings& settings, bus::CanSocketPort& can, std::unique_ptr<bus::GpioLines> gpio,
               bus::LiveClocks clocks, const EventLog& log);

    /// Opens the panel; `now` is the first step of the grid.
    void start(base::Time now);

    struct Instant {
        flight::AircraftState aircraft;  ///< with height_above_terrain
        flight::PhaseStatus phase;
    };
    /// All that was received up to `now`; `now` never goes back. `display` gives the height above the terrain.
    [[nodiscard]] Instant at(base::Time now, display::Display& display);

    /// Flown up to the last at().
    [[nodiscard]] const flight::FlownWay& way() const { return way_; }

    [[nodiscard]] bus::SourceHealth bus_health() const { return can_.health(); }
    [[nodiscard]] const bus::SourceStatistics& bus_statistics() const { return can_.statistics(); }
    [[nodiscard]] bus::BusCounters counters(base::Time now) const { return assembler_.snapshot(now).counters; }

private:
    void feed_until(base::Time time);
    void feed_switches(base::Time time);
    void answer(base::Span<const bus::CanFrame> frames);
    void step_phase(base::Time time, display::Display& display);
    void report_bus(base::Time now);
    void report_switches();

    const EventLog& log_;
    base::FixedString<15> interface_name_;
    bus::NodeSettings node_;
    bus::SocketCanSource can_;
    bus::StateAssembler assembler_;
    bool has_switches_;
    bus::SwitchConfig switch_config_;
    bus::GpiodSource panel_;
    std::optional<bus::SwitchToPhase> switches_;
    display::PhaseMonitor monitor_;
    flight::FlownWay way_;
    base::Time next_step_;
    bus::SourceHealth reported_health_ = bus::SourceHealth::idle;
    bool bus_reported_ = false;
    base::Time bus_reported_at_;
    bool panel_lost_ = false;
};

}  // namespace tedavis::target
