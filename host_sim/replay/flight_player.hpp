/// Plays a recorded bus and its switch log into aircraft state and flight phase, to any instant, forwards or backwards.
///
/// State and phase at T depend on what was recorded up to T alone: the bus is read up to T, the phase is stepped on a fixed
/// grid from the log's first frame. Checkpoints make going back and far jumps cheap.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "bus/switches/switch_log_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "platform/files/file_byte_source.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/phase_monitor.hpp"

namespace tedavis::host_sim {

struct PlayerFiles {
    std::string log, bus, switches, switch_config;  ///< switches may be empty
};

struct PlayedInstant {
    bus::BusSnapshot bus;
    flight::AircraftState aircraft;  ///< with height_above_terrain
    flight::PhaseStatus phase;
    base::Time newest_frame;  ///< receive stamp of the last frame fed
};

class FlightPlayer {
public:
    /// Throws UserError: missing or unreadable files, a log without a single frame, a wrong switch log.
    FlightPlayer(const PlayerFiles& files, display::Display& display);

    /// Stamps of the first and last frame of the log.
    [[nodiscard]] base::Time first() const { return first_; }
    [[nodiscard]] base::Time last() const { return last_; }
    /// Clamped to first() .. last().
    [[nodiscard]] PlayedInstant at(base::Time time);

    /// The phase switches' lines and patterns, and the edges played, in order of time.
    [[nodiscard]] const bus::SwitchConfig& switch_config() const { return switch_config_; }
    [[nodiscard]] const std::vector<bus::SwitchEdge>& switch_edges() const { return edges_; }
    /// Other switches from here on: the edges up to `kept_until` stay, later ones give way to `edges` (all later, in order).
    void replace_switches_after(base::Time kept_until, const std::vector<bus::SwitchEdge>& edges);

    /// Sentences about broken lines, for the report.
    [[nodiscard]] std::vector<std::string> notes() const;
    [[nodiscard]] bus::BusCounters counters_of_whole_log();

private:
    /// All that changes while playing; copied as a checkpoint.
    struct Progress {
        bus::LogPosition position;
        bus::StateAssembler assembler;
        std::optional<bus::SwitchToPhase> switches;
        std::size_t next_edge = 0;
        display::PhaseMonitor monitor;
        std::int64_t next_step = 0;
        base::Time reached;
        base::Time newest_frame;
    };
    void open_log(const PlayerFiles& files);
    void open_switches(const PlayerFiles& files);
    void find_extent();
    void restart();
    void go_back_before(base::Time time);
    void advance(base::Time time);
    void feed_until(base::Time time);
    void step_phase(base::Time time);

    display::Display& display_;
    std::string log_name_;
    platform::FileByteSource log_file_;
    std::vector<char> window_;
    std::unique_ptr<bus::CandumpLogSource> source_;
    bus::LogPosition start_;
    bus::BusSettings bus_settings_;
    std::string switch_name_;
    std::vector<bus::SwitchEdge> edges_;
    bus::SwitchConfig switch_config_;
    std::vector<std::string> switch_notes_;
    base::Time first_, last_;
    Progress progress_;
    std::vector<Progress> checkpoints_;
};

}  // namespace tedavis::host_sim
