#include "host_sim/replay/flight_player.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>

#include "host_sim/atomic_file.hpp"
#include "host_sim/importers/flight_importer.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/open_log.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kWindowBytes = 1 << 20;
constexpr std::uint64_t kLargestIndex = 64u << 20;
/// Beyond the time until every value is lost: what dwells and holds of the phase take.
constexpr base::Duration kPhaseSettles = base::Duration::seconds(30);
constexpr base::Time kEnd{std::numeric_limits<std::int64_t>::max()};

std::string line_note(const std::string& file, std::uint64_t line, const char* reason) {
    return file + ":" + std::to_string(line) + ": " + reason;
}

base::Duration quiet_after(const bus::BusSettings& settings) {
    base::Duration longest = settings.phase.timeout;
    for (const base::FreshnessLimits& limits : settings.limits) longest = std::max(longest, limits.lost);
    return longest + kPhaseSettles;
}

base::Time wall_clock_now() {
    const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
    return {std::chrono::duration_cast<std::chrono::nanoseconds>(since_epoch).count()};
}

std::string index_name(const std::string& log) { return log + ".tdx"; }

}  // namespace

PlayerFiles player_files(const ReplayOptions& options) {
    return {options.log,   options.picture.bus,   options.switches, options.switch_config, options.picture.aircraft,
            options.phase, options.aircraft_class};
}

IndexPolicy index_policy(const ReplayOptions& options) {
    IndexPolicy policy;
    if (!options.keeps_index) policy.smallest_kept_log = std::numeric_limits<std::uint64_t>::max();
    return policy;
}

FlightPlayer::FlightPlayer(const PlayerFiles& files, display::Display& display, Console* console, const IndexPolicy& policy)
    : FlightPlayer(files, {display.planner(), display.planner().terrain_database()}, console, policy) {}

FlightPlayer::FlightPlayer(const PlayerFiles& files, const PlayedGround& ground, Console* console, const IndexPolicy& policy)
    : heights_(ground.heights), console_(console), policy_(policy) {
    open_bus(files);
    open_log(files);
    open_switches(files);
    take_phases(files);
    bus_name_ = files.bus;
    key_.parts[IndexKey::program] = program_identity();
    key_.parts[IndexKey::terrain] = terrain_identity(ground.terrain);
    const base::Time opened = wall_clock_now();
    const FileIdentity log = identify_log();
    key_.parts[IndexKey::log] = log.hash;
    if (!take_kept_index()) {
        make_index();
        keep_index(log, opened);
    }
    first_ = index_.facts.first;
    last_ = index_.facts.last;
    append(switch_findings_, switch_time_findings(files.switches, edges_, first_, last_));
    start_from_checkpoint(first_);
}

void FlightPlayer::open_bus(const PlayerFiles& files) {
    const std::string path = resolve_config(files.bus, "buses");
    const std::string text = read_file(path);
    auto settings = bus::load_bus_settings(text, path);
    if (!settings.ok()) throw UserError(std::string(settings.error().message.view()));
    bus_settings_ = settings.value();
    quiet_ = quiet_after(bus_settings_);
    key_.parts[IndexKey::bus] = text_identity(text);
}

void FlightPlayer::take_phases(const PlayerFiles& files) {
    const flight::AircraftClass aircraft = files.aircraft_class.value_or(load_aircraft(files.aircraft).aircraft_class);
    phases_.motion = flight::motion_phase_settings(aircraft);
    phases_.motion.is_enabled = files.phase != kNoPhase;
    if (!files.phase.empty() && files.phase != kNoPhase) phases_.stated = {flight::phase_from_name(files.phase).phase, true};
    const bool is_usual = aircraft == flight::AircraftClass::unstated && files.phase.empty();
    key_.parts[IndexKey::phases] = is_usual ? 0 : text_identity(std::to_string(static_cast<int>(aircraft)) + files.phase);
}

void FlightPlayer::open_log(const PlayerFiles& files) {
    log_name_ = files.log;
    log_bytes_ = host_sim::open_log(files.log);
    window_.resize(kWindowBytes);
    source_ = std::make_unique<bus::CandumpLogSource>(*log_bytes_, base::Span<char>(window_.data(), window_.size()));
    start_ = source_->position();
    constexpr auto kAllFrames = std::numeric_limits<std::uint32_t>::max();
    tracker_.emplace(progress_.tracker, bus::TrackerPorts{*source_, &panel_, this, kAllFrames});
}

void FlightPlayer::open_switches(const PlayerFiles& files) {
    const std::string path = resolve_config(files.switch_config, "switches");
    const std::string config_text = read_file(path);
    auto config = bus::load_switch_config(config_text, path);
    if (!config.ok()) throw UserError(std::string(config.error().message.view()));
    switch_config_ = config.value();
    key_.parts[IndexKey::switch_config] = text_identity(config_text);
    if (files.switches.empty()) return;
    const std::string text = read_switch_log(files.switches);
    key_.parts[IndexKey::switch_log] = text_identity(text);
    PanelReading reading = read_panel(text, switch_config_);
    for (const bus::SwitchLineReport& report : reading.reports)
        switch_notes_.push_back(line_note(files.switches, report.line, bus::describe(report.fault)));
    switch_findings_ = switch_findings(files.switches, text, files.switch_config, switch_config_, reading);
    edges_ = std::move(reading.edges);
}

FileIdentity FlightPlayer::identify_log() { return file_identity(log_name_, *log_bytes_); }

bool FlightPlayer::take_kept_index() {
    if (log_bytes_->size() < policy_.smallest_kept_log) return false;
    const std::string path = index_name(log_name_);
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    if (error) return false;
    UnpackedIndex unpacked{{}, "is too large"};
    if (bytes <= kLargestIndex) unpacked = unpack_index(read_file(path), key_, policy_.spacing);
    if (!unpacked.index) {
        say(path + ": it " + unpacked.refusal + "; the log is indexed anew");
        return false;
    }
    index_ = std::move(*unpacked.index);
    has_kept_index_ = true;
    return true;
}

/// A replay that cannot keep its index is as good as one that can, only slower to start.
void FlightPlayer::keep_index(const FileIdentity& log, base::Time opened) {
    if (log_bytes_->size() < policy_.smallest_kept_log) return;
    if (log.changed_ns > opened.ns - policy_.rest.ns || identify_log().hash != log.hash)
        return say(log_name_ + ": it has just been changed; its index is not kept");
    try {
        write_file_atomically(index_name(log_name_), pack_index(index_, key_));
        has_kept_index_ = true;
    } catch (const UserError& error) {
        say(std::string(error.what()) + "; its index is not kept");
    }
}

void FlightPlayer::refuse_log() const {
    const std::string format = recorded_format(log_name_);
    if (format.empty()) throw UserError(log_name_ + ": no CAN frame in this file; give a log as candump -L writes it");
    throw UserError(log_name_ + ": a recorded flight (" + format +
                    "), not a bus log; 'tedavis fly FLIGHT -o DIR' makes its report, "
                    "'tedavis convert FLIGHT -o flight.log' a bus log");
}

void FlightPlayer::make_index() {
    bus::CanFrame frame;
    if (source_->read(kEnd, {&frame, 1}) == 0) refuse_log();
    first_ = frame.time;
    index_.track = CheckpointTrack(policy_.spacing);
    index_.outline = FlightOutline();
    start();
    const InterruptGuard interrupt;
    while (source_->health() != bus::SourceHealth::ended && next_step_is_by(kEnd)) {
        run_step();
        outline_step();
        if (console_ != nullptr) console_->progress("indexing " + log_name_, source_->position().offset, log_bytes_->size());
        if (policy_.told) policy_.told(source_->position().offset, log_bytes_->size());
        if (interrupt.requested()) throw Interrupted(log_name_ + ": interrupted while it was indexed; nothing was written");
    }
    if (console_ != nullptr) console_->progress_done();
    index_.facts = facts_of(*source_, progress_.tracker.assembler, progress_.frames_of, first_);
}

void FlightPlayer::start() {
    progress_ = FlightProgress();
    progress_.position = start_;
    progress_.tracker = bus::TrackerMemory(bus_settings_, &switch_config_, first_, phases_);
    progress_.reached = first_ - base::Duration::seconds(1);
    source_->seek(start_);
    index_.track.offer(progress_);
}

void FlightPlayer::start_from_checkpoint(base::Time time) {
    progress_ = index_.track.unpack(time);
    source_->seek(progress_.position);
}

/// Leaps over the steps that nothing can change, to the first one that has a new frame or edge behind it.
bool FlightPlayer::next_step_is_by(base::Time time) {
    base::Time newest = source_->position().newest;
    if (progress_.next_edge > 0) newest = std::max(newest, edges_[progress_.next_edge - 1].time);
    if (tracker_->next_step() - quiet_ > newest) {
        const base::Time event = next_event();
        if (event == kEnd) return false;
        tracker_->skip_steps_before(event);
    }
    return tracker_->next_step() <= time;
}

/// The next frame or edge; kEnd after the last one.
base::Time FlightPlayer::next_event() {
    const bus::LogPosition here = source_->position();
    bus::CanFrame frame;
    const base::Time of_log = source_->read(kEnd, {&frame, 1}) == 1 ? frame.time : kEnd;
    source_->seek(here);
    return progress_.next_edge < edges_.size() ? std::min(of_log, edges_[progress_.next_edge].time) : of_log;
}

void FlightPlayer::receive(base::Span<const bus::CanFrame> frames) {
    for (const bus::CanFrame& frame : frames) {
        ++progress_.frames_of[frame.channel];
        progress_.newest_frame = frame.time;
    }
}

void FlightPlayer::check_log() const {
    if (source_->health() == bus::SourceHealth::failed)
        throw UserError(log_name_ + ": cannot be read beyond byte " + std::to_string(source_->position().offset) +
                        "; check the medium it lies on");
}

void FlightPlayer::run_step() {
    progress_.reached = tracker_->next_step();
    tracker_->step(heights_);
    check_log();
    ++progress_.steps_run;
    progress_.position = source_->position();
    index_.track.offer(progress_);
}

void FlightPlayer::outline_step() {
    const base::Time time = progress_.reached;
    const bus::TrackerMemory& tracker = progress_.tracker;
    index_.outline.add_phase(tracker.monitor.status().presented, time);
    if (index_.outline.wants_place(time)) index_.outline.add_place(tracker.assembler.snapshot(time).state.own_ship, time);
}

flight::FrameInput FlightPlayer::at(base::Time time) {
    const base::Time wanted = std::min(std::max(time, first_), last_);
    if (wanted < progress_.reached || index_.track.reached_by(wanted) > progress_.reached) start_from_checkpoint(wanted);
    while (next_step_is_by(wanted)) run_step();
    const flight::FrameInput input = tracker_->input_at(wanted, heights_);
    check_log();
    progress_.reached = wanted;
    return input;
}

void FlightPlayer::replace_switches_after(base::Time kept_until, const std::vector<bus::SwitchEdge>& edges) {
    const auto later =
        std::find_if(edges_.begin(), edges_.end(), [kept_until](const bus::SwitchEdge& e) { return e.time > kept_until; });
    edges_.erase(later, edges_.end());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    index_.track.drop_after(kept_until);
    if (progress_.reached > kept_until) start_from_checkpoint(kept_until);
}

Findings FlightPlayer::findings() const {
    Findings findings = log_findings(log_name_, bus_name_, index_.facts);
    append(findings, switch_findings_);
    return findings;
}

std::vector<std::string> FlightPlayer::notes() const {
    std::vector<std::string> notes = switch_notes_;
    const LogFacts& facts = index_.facts;
    for (const bus::LineReport& report : facts.reports)
        notes.push_back(line_note(log_name_, report.line, bus::describe(report.fault)));
    if (facts.broken_lines > facts.reports.size())
        notes.push_back(log_name_ + ": " + std::to_string(facts.broken_lines) + " broken lines in all; only the first " +
                        std::to_string(facts.reports.size()) + " are named");
    if (facts.lines.other > 0)
        notes.push_back(log_name_ + ": " + std::to_string(facts.lines.other) +
                        (facts.lines.other == 1 ? " line does" : " lines do") +
                        " not begin with '(' as candump's do, passed over");
    return notes;
}

void FlightPlayer::say(const std::string& message) {
    if (console_ != nullptr) console_->note(message);
}

}  // namespace tedavis::host_sim
