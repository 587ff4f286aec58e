/// The aircraft as the live bus and the live panel state it: the counterpart of a replay's player.
///
/// The tracker reads both, so the phase passes through the same steps as in a replay. What is missing is never fatal: a bus or a
/// panel that is not there is reported once to the event log, and the display shows its flags. A panel that fails stays so until
/// the next start. Requests for identification are answered where the bus file says so.
///
/// Thread  one. Memory  inside; nothing after start(). Time  monotonic, from the caller.
#pragma once

#include <memory>

#include "bus/socketcan/socketcan_source.hpp"
#include "bus/switches/gpiod_source.hpp"
#include "bus/tracker/flight_tracker.hpp"
#include "target/board_config.hpp"
#include "target/event_log.hpp"

namespace tedavis::target {

class LiveFlight final : private bus::FrameListener {
public:
    /// `can`, `clocks` and `log` must outlive it. `gpio` may be null: then a panel that the board file asks for is missing.
    LiveFlight(const BoardSettings& settings, bus::CanSocketPort& can, std::unique_ptr<bus::GpioLines> gpio,
               bus::LiveClocks clocks, const EventLog& log);

    /// Opens the panel; `now` is the first step of the grid.
    void start(base::Time now);

    /// All that was received up to `now`; `now` never goes back.
    [[nodiscard]] flight::FrameInput at(base::Time now, flight::TerrainHeights& heights);

    [[nodiscard]] bus::SourceHealth bus_health() const { return can_.health(); }
    [[nodiscard]] const bus::SourceStatistics& bus_statistics() const { return can_.statistics(); }
    [[nodiscard]] bus::BusCounters counters(base::Time now) const { return memory_.assembler.snapshot(now).counters; }

private:
    void receive(base::Span<const bus::CanFrame> frames) override;
    void report_bus(base::Time now);
    void report_switches();

    const EventLog& log_;
    base::FixedString<15> interface_name_;
    bus::NodeSettings node_;
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
