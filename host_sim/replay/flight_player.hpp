/// Plays a recorded bus and its switch log into aircraft state and flight phase, to any instant, forwards or backwards.
///
/// State and phase at T depend on what was recorded up to T alone: the bus is read up to T, the phase is stepped on a fixed
/// grid from the log's first frame. Where the recording pauses until every value is lost, the steps pause as well.
///
/// Opening plays the whole log once and leaves checkpoints, so that every instant is near. Of a long log they are kept in
/// LOG.tdx (flight_index.hpp) for the next time. Memory  some megabytes, however long the log; a gzip-compressed one lies
/// unpacked in memory.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "host_sim/console.hpp"
#include "host_sim/replay/flight_index.hpp"
#include "host_sim/replay/read_switch_log.hpp"
#include "render_core/display/display.hpp"

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

struct IndexPolicy {
    std::uint64_t smallest_kept_log = 32u << 20;  ///< shorter logs are read again each time; it takes a moment
    /// A log changed less than this long before is not trusted to show its next change in its times.
    base::Duration rest = base::Duration::seconds(2);
    CheckpointSpacing spacing;
};

class FlightPlayer {
public:
    /// Shows progress and says on the console why an index is made anew or cannot be kept; null: in silence.
    /// Throws UserError: missing or unreadable files, a log without a single frame, a wrong switch log; Interrupted.
    FlightPlayer(const PlayerFiles& files, display::Display& display, Console* console = nullptr,
                 const IndexPolicy& policy = IndexPolicy());

    /// Stamps of the first and last frame of the log.
    [[nodiscard]] base::Time first() const { return first_; }
    [[nodiscard]] base::Time last() const { return last_; }
    /// Clamped to first() .. last().
    [[nodiscard]] PlayedInstant at(base::Time time);
    /// Flown up to the instant that was asked for last.
    [[nodiscard]] const flight::FlownWay& way() const { return progress_.way; }

    /// The phase switches' lines and patterns, and the edges played, in order of time.
    [[nodiscard]] const bus::SwitchConfig& switch_config() const { return switch_config_; }
    [[nodiscard]] const std::vector<bus::SwitchEdge>& switch_edges() const { return edges_; }
    /// Other switches from here on: the edges up to `kept_until` stay, later ones give way to `edges` (all later, in order).
    void replace_switches_after(base::Time kept_until, const std::vector<bus::SwitchEdge>& edges);

    /// Sentences about broken and foreign lines, for the report.
    [[nodiscard]] std::vector<std::string> notes() const;
    /// Of the whole log.
    [[nodiscard]] const LogFacts& facts() const { return index_.facts; }
    /// What is wrong with the log and the switch log.
    [[nodiscard]] Findings findings() const;

private:
    void open_bus(const PlayerFiles& files);
    void open_log(const PlayerFiles& files);
    void open_switches(const PlayerFiles& files);
    [[nodiscard]] FileIdentity identify_log();
    [[nodiscard]] bool take_kept_index();
    void keep_index(const FileIdentity& log, base::Time opened);
    void make_index();
    void start();
    void start_from_checkpoint(base::Time time);
    [[nodiscard]] base::Time step_time() const;
    [[nodiscard]] bool next_step_is_by(base::Time time);
    [[nodiscard]] base::Time next_event();
    void run_step();
    void feed_until(base::Time time);
    void step_phase(base::Time time);
    void say(const std::string& sentence);

    display::Display& display_;
    Console* console_;
    IndexPolicy policy_;
    std::string log_name_, bus_name_;
    std::unique_ptr<base::ByteSource> log_bytes_;
    std::vector<char> window_;
    std::unique_ptr<bus::CandumpLogSource> source_;
    bus::LogPosition start_;
    bus::BusSettings bus_settings_;
    base::Duration quiet_;  ///< this long after the last frame or edge nothing changes any more
    std::vector<bus::SwitchEdge> edges_;
    bus::SwitchConfig switch_config_;
    std::vector<std::string> switch_notes_;
    Findings switch_findings_;  ///< of the log that was given
    IndexKey key_;
    base::Time first_, last_;
    FlightProgress progress_;
    FlightIndex index_;
};

}  // namespace tedavis::host_sim
