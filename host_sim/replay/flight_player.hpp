/// Plays a recorded bus log and its switch log and returns aircraft state and flight phase at any time, forwards or backwards.
///
/// The tracker (bus/tracker/flight_tracker.hpp) reads the recording in steps of a grid that begins at the log's first frame. In a
/// gap of the recording, steps are skipped once every value is lost.
///
/// The constructor plays the whole log once and makes checkpoints, so that any time is reached quickly. Those of a long log are
/// stored in LOG.tdx (flight_index.hpp) for the next run. Memory  some megabytes for any length of the log; a gzip-compressed log
/// is unpacked into memory.
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
    std::string aircraft{};  ///< aircraft file, whose class is used to detect the phase from motion; empty: none
    std::string phase{};     ///< as ReplayOptions::phase
    std::optional<flight::AircraftClass> aircraft_class{};  ///< overrides the class of the aircraft file
};
[[nodiscard]] PlayerFiles player_files(const ReplayOptions& options);

struct IndexPolicy {
    std::uint64_t smallest_kept_log = 32u << 20;  ///< bytes; the index of a smaller log is not stored
    /// The index of a log that was changed less than this time ago is not stored: another change might leave its file times
    /// equal.
    base::Duration rest = base::Duration::seconds(2);
    CheckpointSpacing spacing;
    /// Called often while the log is indexed, with the bytes read and the bytes in all; may throw.
    std::function<void(std::uint64_t done, std::uint64_t total)> told{};
};

/// The policy that the options request.
[[nodiscard]] IndexPolicy index_policy(const ReplayOptions& options);

/// The terrain over which a flight is played.
struct PlayedGround {
    flight::TerrainHeights& heights;
    const terrain::TerrainDatabase* terrain = nullptr;  ///< null: none
};

class FlightPlayer final : private bus::FrameListener {
public:
    /// Opens the files and indexes the log. The console shows progress and why an index is made again or cannot be stored; null:
    /// no messages. Throws UserError for missing or unreadable files, a log without a frame, or a wrong switch log; Interrupted.
    FlightPlayer(const PlayerFiles& files, display::Display& display, Console* console = nullptr,
                 const IndexPolicy& policy = IndexPolicy());
    /// The same without a display.
    FlightPlayer(const PlayerFiles& files, const PlayedGround& ground, Console* console, const IndexPolicy& policy);

    /// Stamps of the first and last frame of the log.
    [[nodiscard]] base::Time first() const { return first_; }
    [[nodiscard]] base::Time last() const { return last_; }
    /// Returns the input of a frame at `time`, clamped to first() .. last(). The trail in it is valid until the next call.
    [[nodiscard]] flight::FrameInput at(base::Time time);
    /// At the time of the last call of at(): the state from the bus, and the receive stamp of its newest frame.
    [[nodiscard]] const bus::StateAssembler& assembler() const { return progress_.tracker.assembler; }
    [[nodiscard]] base::Time newest_frame() const { return progress_.newest_frame; }

    /// Lines and patterns of the phase switches, and the edges that are played, ascending in time.
    [[nodiscard]] const bus::SwitchConfig& switch_config() const { return switch_config_; }
    [[nodiscard]] const std::vector<bus::SwitchEdge>& switch_edges() const { return edges_; }
    /// Keeps the switch edges up to `kept_until` and replaces the later ones by `edges`, which are later and ascending in time.
    void replace_switches_after(base::Time kept_until, const std::vector<bus::SwitchEdge>& edges);

    /// Messages about broken and unknown lines of the logs, for the report.
    [[nodiscard]] std::vector<std::string> notes() const;
    /// Counts of the whole log.
    [[nodiscard]] const LogFacts& facts() const { return index_.facts; }
    /// Outline of the whole log, with the switch log that was given at the start.
    [[nodiscard]] const FlightOutline& outline() const { return index_.outline; }
    /// The identities on which the played flight depends: the program, the log, and the files with which it is played.
    [[nodiscard]] const IndexKey& key() const { return key_; }
    /// Whether the log's index is stored beside it; only then other data that depend on the log may be stored, too.
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
    base::Duration quiet_;  ///< time after the last frame or edge after which nothing changes
    std::vector<bus::SwitchEdge> edges_;
    bus::SwitchConfig switch_config_;
    std::vector<std::string> switch_notes_;
    Findings switch_findings_;  ///< of the switch log that was given
    IndexKey key_;
    bool has_kept_index_ = false;
    base::Time first_, last_;
    FlightProgress progress_;
    PlayedEdges panel_{edges_, progress_.next_edge};
    std::optional<bus::FlightTracker> tracker_;  ///< has a value once the log is open
    FlightIndex index_;
};

}  // namespace tedavis::host_sim
