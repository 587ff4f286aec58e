/// Tracks the aircraft from the live bus and the live switch panel; the counterpart of a replay's flight player.
///
/// A FlightTracker reads both, so the phase passes through the same steps as in a replay. A missing bus or panel is not fatal:
/// it is reported once to the event log, and the display shows its flags. A panel that fails stays failed until the next start.
/// Identification requests are answered where the bus file enables it.
///
/// Thread  one. Memory  inside; nothing after start(). Time  the monotonic clock's, passed by the caller.
#pragma once

#include <memory>

#include "bus/canaerospace/phase_report.hpp"
#include "bus/socketcan/socketcan_source.hpp"
#include "bus/switches/gpiod_source.hpp"
#include "bus/tracker/flight_tracker.hpp"
#include "target/board_config.hpp"
#include "target/can_latency.hpp"
#include "target/event_log.hpp"

namespace tedavis::target {

/// Says in one sentence why the lines of a panel cannot be read; empty where it sees no fault. Start-up only.
using PanelExplainer = base::Error (*)(const bus::SwitchConfig& panel);

class LiveFlight final : private bus::FrameListener {
public:
    /// `can`, `clocks` and `log` must outlive the object. `gpio` may be null; a panel that the board file names then counts as
    /// missing. `explain` says why a panel cannot be opened, better than the library that opens it; null, or an empty answer:
    /// what that one says.
    LiveFlight(const BoardSettings& settings, bus::CanSocketPort& can, std::unique_ptr<bus::GpioLines> gpio,
               bus::LiveClocks clocks, const EventLog& log, PanelExplainer explain = nullptr);

    /// Opens the panel; `now` is the first step of the grid.
    void start(base::Time now);

    /// Returns the input of a frame at `now`, from everything received up to `now`, which must not decrease.
    [[nodiscard]] flight::FrameInput at(base::Time now, flight::TerrainHeights& heights);

    [[nodiscard]] bus::SourceHealth bus_health() const { return can_.health(); }
    [[nodiscard]] const bus::SourceStatistics& bus_statistics() const { return can_.statistics(); }
    /// Knows the frames that at() has read; is to be told when the screen shows a picture.
    [[nodiscard]] CanLatency& latency() { return latency_; }
    [[nodiscard]] bus::BusCounters counters(base::Time now) const { return memory_.assembler.snapshot(now).counters; }

private:
    void receive(base::Span<const bus::CanFrame> frames) override;
    void report_bus(base::Time now);
    void write_bus_fault(bus::SourceHealth health);
    void report_switches();
    void report_phase(const flight::PhaseStatus& phase, base::Time now);

    const EventLog& log_;
    bus::CanSocketPort& port_;
    bus::SocketCanSettings can_settings_;
    PanelExplainer explain_panel_;
    bus::NodeSettings node_;
    bus::PhaseReport phase_report_;
    CanLatency latency_;
    bus::SocketCanSource can_;
    bool has_switches_;
    bus::SwitchConfig switch_config_;
    bus::GpiodSource panel_;
    bus::TrackerMemory memory_;
    bus::FlightTracker tracker_;
    bus::SourceHealth reported_health_ = bus::SourceHealth::idle;
    bool bus_reported_ = false;
    base::Time bus_reported_at_;
    bool panel_lost_ = false;
};

}  // namespace tedavis::target
