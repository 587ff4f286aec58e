/// Plays a recorded bus and its switch log into aircraft state and flight phase, to any instant, forwards or backwards.
///
/// The tracker (bus/tracker/flight_tracker.hpp) reads the recording, on a grid from the log's first frame. Where the recording
/// pauses until every value is lost, its steps pause as well.
///
/// Opening plays the whole log once and leaves checkpoints, so that every instant is near. Of a long log they are kept in
/// LOG.tdx (flight_index.hpp) for the next time. Memory  some megabytes, however long the log; a gzip-compressed one lies
/// unpacked in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/flight_index.hpp"
#include "host_sim/replay/played_edges.hpp"
#include "host_sim/replay/read_switch_log.hpp"
#include "render_core/display/display.hpp"

namespace tedavis::host_sim {

struct PlayerFiles {
    std::string log, bus, switches, switch_config;  ///< switches may be empty
    std::string aircraft{};                         ///< aircraft file, whose class motion is judged by; empty: none is stated
    std::string phase{};                            ///< as ReplayOptions::phase
    std::optional<flight::AircraftClass> aircraft_class{};  ///< in place of the file's
};
[[nodiscard]] PlayerFiles player_files(const ReplayOptions& options);

struct IndexPolicy {
    std::uint64_t smallest_kept_log = 32u << 20;  ///< shorter logs are read again each time; it takes a moment
    /// A log changed less than this long before is not trusted to show its next change in its times.
    base::Duration rest = base::Duration::seconds(2);
    CheckpointSpacing spacing;
    /// Called often while the log is indexed, with the bytes read and all of them; may throw.
    std::function<void(std::uint64_t done, std::uint64_t total)> told{};
};

/// As the options ask for it.
[[nodiscard]] IndexPolicy index_policy(const ReplayOptions& options);

/// What a flight is played over.
struct PlayedGround {
    flight::TerrainHeights& heights;
    const terrain::TerrainDatabase* terrain = nullptr;  ///< null: none
};

class FlightPlayer final : private bus::FrameListener {
public:
    /// Shows progress and says on the console why an index is made anew or cannot be kept; null: in silence.
    /// Throws UserError: missing or unreadable files, a log without a single frame, a wrong switch log; Interrupted.
    FlightPlayer(const PlayerFiles& files, display::Display& display, Console* console = nullptr,
                 const IndexPolicy& policy = IndexPolicy());
    /// The same without a display.
    FlightPlayer(const PlayerFiles& files, const PlayedGround& ground, Console* console, const IndexPolicy& policy);

    /// Stamps of the first and last frame of the log.
    [[nodiscard]] base::Time first() const { return first_; }
    [[nodiscard]] base::Time last() const { return last_; }
    /// At `time` clamped to first() .. last(). The trail is good until the next call.
    [[nodiscard]] flight::FrameInput at(base::Time time);
    /// Of the instant that was asked for last: what the bus has said, and the receive stamp of its last frame.
    [[nodiscard]] const bus::StateAssembler& assembler() const { return progress_.tracker.assembler; }
    [[nodiscard]] base::Time newest_frame() const { return progress_.newest_frame; }

    /// The phase switches' lines and patterns, and the edges played, in order of time.
    [[nodiscard]] const bus::SwitchConfig& switch_config() const { return switch_config_; }
    [[nodiscard]] const std::vector<bus::SwitchEdge>& switch_edges() const { return edges_; }
    /// Replaces switch edges: those up to `kept_until` are kept, and later ones are replaced by `edges` (all later, in order).
    void replace_switches_after(base::Time kept_until, const std::vector<bus::SwitchEdge>& edges);

    /// Sentences about broken and foreign lines, for the report.
    [[nodiscard]] std::vector<std::string> notes() const;
    /// Of the whole log.
    [[nodiscard]] const LogFacts& facts() const { return index_.facts; }
    /// Of the whole log, with the switches that it was opened with.
    [[nodiscard]] const FlightOutline& outline() const { return index_.outline; }
    /// What the flight follows from: the program, the log, and the files that it is played with.
    [[nodiscard]] const IndexKey& key() const { return key_; }
    /// Whether the log's index lies beside it: only then something else that follows from the log may be kept, too.
    [[nodiscard]] bool has_kept_index() const { return has_kept_index_; }
    /// What is wrong with the log and the switch log.
    [[nodiscard]] Findings findings() const;

private:
    void open_bus(const PlayerFiles& files);
    void take_phases(const PlayerFiles& files);
    void open_log(const PlayerFiles& files);
    void open_switches(const PlayerFiles& files);
    [[nodiscard]] FileIdentity identify_log();
    [[nodiscard]] bool take_kept_index();
    void keep_index(const FileIdentity& log, base::Time opened);
    void make_index();
    [[noreturn]] void refuse_log() const;
    void start();
    void start_from_checkpoint(base::Time time);
    [[nodiscard]] bool next_step_is_by(base::Time time);
    [[nodiscard]] base::Time next_event();
    void run_step();
    void outline_step();
    void receive(base::Span<const bus::CanFrame> frames) override;
    void check_log() const;
    void say(const std::string& message);

    flight::TerrainHeights& heights_;
    Console* console_;
    IndexPolicy policy_;
    std::string log_name_, bus_name_;
    std::unique_ptr<base::ByteSource> log_bytes_;
    std::vector<char> window_;
    std::unique_ptr<bus::CandumpLogSource> source_;
    bus::LogPosition start_;
    bus::BusSettings bus_settings_;
    flight::PhaseSettings phases_;
    base::Duration quiet_;  ///< this long after the last frame or edge nothing changes any more
    std::vector<bus::SwitchEdge> edges_;
    bus::SwitchConfig switch_config_;
    std::vector<std::string> switch_notes_;
    Findings switch_findings_;  ///< of the log that was given
    IndexKey key_;
    bool has_kept_index_ = false;
    base::Time first_, last_;
    FlightProgress progress_;
    PlayedEdges panel_{edges_, progress_.next_edge};
    std::optional<bus::FlightTracker> tracker_;  ///< there once the log is open
    FlightIndex index_;
};

}  // namespace tedavis::host_sim
