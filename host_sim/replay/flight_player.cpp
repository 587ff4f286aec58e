#include "host_sim/replay/flight_player.hpp"

#include <algorithm>
#include <limits>

#include "bus/switches/switch_log.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kWindowBytes = 1 << 20;
constexpr std::size_t kFramesAtOnce = 256;
constexpr base::Duration kCheckpointSpacing = base::Duration::seconds(30);
constexpr base::Time kEnd{std::numeric_limits<std::int64_t>::max()};

bus::BusSettings load_bus(const std::string& name) {
    const std::string path = resolve_config(name, "buses");
    auto settings = bus::load_bus_settings(read_file(path), path);
    if (!settings.ok()) throw UserError(std::string(settings.error().sentence.view()));
    return settings.value();
}

std::string line_note(const std::string& file, std::uint64_t line, const char* reason) {
    return file + ":" + std::to_string(line) + ": " + reason;
}

}  // namespace

FlightPlayer::FlightPlayer(const PlayerFiles& files, display::Display& display)
    : display_(display), bus_settings_(load_bus(files.bus)) {
    open_log(files);
    open_switches(files);
    find_extent();
    restart();
}

void FlightPlayer::open_log(const PlayerFiles& files) {
    log_name_ = files.log;
    auto file = platform::open_file(files.log.c_str());
    if (!file.ok()) throw UserError(std::string(file.error().sentence.view()));
    log_file_ = std::move(file.value());
    window_.resize(kWindowBytes);
    source_ = std::make_unique<bus::CandumpLogSource>(log_file_, base::Span<char>(window_.data(), window_.size()));
    start_ = source_->position();
}

void FlightPlayer::open_switches(const PlayerFiles& files) {
    const std::string path = resolve_config(files.switch_config, "switches");
    auto config = bus::load_switch_config(read_file(path), path);
    if (!config.ok()) throw UserError(std::string(config.error().sentence.view()));
    switch_config_ = config.value();
    if (files.switches.empty()) return;
    const std::string text = read_file(files.switches);
    if (!bus::has_switch_log_header(text))
        throw UserError(files.switches + ":1: not a switch log; its first line must be '# tedavis switch log 1'");
    bus::SwitchLogSource log(text, switch_config_);
    bus::SwitchEdge batch[kFramesAtOnce];
    for (std::size_t count = 1; count > 0;) {
        count = log.read(kEnd, base::Span<bus::SwitchEdge>(batch));
        edges_.insert(edges_.end(), batch, batch + count);
    }
    for (const bus::SwitchLineReport& report : log.reports())
        switch_notes_.push_back(line_note(files.switches, report.line, bus::describe(report.fault)));
}

void FlightPlayer::find_extent() {
    std::vector<bus::CanFrame> batch(kFramesAtOnce);
    bool any = false;
    for (std::size_t count = 1; count > 0;) {
        count = source_->read(kEnd, {batch.data(), batch.size()});
        if (count == 0) break;
        if (!any) first_ = batch[0].time;
        for (std::size_t n = 0; n < count; ++n) last_ = any && batch[n].time < last_ ? last_ : batch[n].time;
        any = true;
    }
    if (!any) throw UserError(log_name_ + ": no CAN frame in this file; give a log as candump -L writes it");
}

void FlightPlayer::restart() {
    progress_ = Progress();
    progress_.position = start_;
    progress_.assembler = bus::StateAssembler(bus_settings_);
    progress_.switches.emplace(switch_config_);
    progress_.reached = first_ - base::Duration::seconds(1);
    source_->seek(start_);
    if (checkpoints_.empty()) checkpoints_.push_back(progress_);
}

void FlightPlayer::go_back_before(base::Time time) {
    const auto later = std::upper_bound(checkpoints_.begin(), checkpoints_.end(), time,
                                        [](base::Time t, const Progress& p) { return t < p.reached; });
    progress_ = *(later - 1);
    source_->seek(progress_.position);
}

void FlightPlayer::feed_until(base::Time time) {
    bus::CanFrame batch[kFramesAtOnce];
    for (std::size_t count = kFramesAtOnce; count == kFramesAtOnce;) {
        count = source_->read(time, base::Span<bus::CanFrame>(batch));
        progress_.assembler.feed({batch, count});
        if (count > 0) progress_.newest_frame = batch[count - 1].time;
    }
    progress_.assembler.note_dropped(source_->statistics().dropped);
    for (; progress_.next_edge < edges_.size() && edges_[progress_.next_edge].time <= time; ++progress_.next_edge)
        progress_.switches->add(edges_[progress_.next_edge]);
}

void FlightPlayer::step_phase(base::Time time) {
    const bus::BusSnapshot snapshot = progress_.assembler.snapshot(time);
    flight::AircraftState aircraft = snapshot.state;
    aircraft[flight::Signal::height_above_terrain] = display_.height_above_terrain(aircraft.own_ship, time);
    flight::PhaseInputs inputs;
    inputs.can = snapshot.phase_status.phase;
    const bus::SwitchPhase switches = progress_.switches->status(time);
    inputs.switches = switches.statement;
    inputs.switch_fault = switches.fault;
    progress_.monitor.step(aircraft, inputs, time);
}

void FlightPlayer::advance(base::Time time) {
    for (;;) {
        const base::Time step = first_ + base::Duration{display::PhaseMonitor::kStep.ns * progress_.next_step};
        if (step > time) break;
        feed_until(step);
        step_phase(step);
        ++progress_.next_step;
        progress_.reached = step;
        progress_.position = source_->position();
        if (step - checkpoints_.back().reached >= kCheckpointSpacing) checkpoints_.push_back(progress_);
    }
}

PlayedInstant FlightPlayer::at(base::Time time) {
    const base::Time wanted = std::min(std::max(time, first_), last_);
    if (wanted < progress_.reached) go_back_before(wanted);
    advance(wanted);
    feed_until(wanted);
    PlayedInstant instant;
    instant.bus = progress_.assembler.snapshot(wanted);
    instant.aircraft = instant.bus.state;
    instant.aircraft[flight::Signal::height_above_terrain] = display_.height_above_terrain(instant.aircraft.own_ship, wanted);
    instant.phase = progress_.monitor.status();
    instant.newest_frame = progress_.newest_frame;
    progress_.reached = wanted;
    return instant;
}

void FlightPlayer::replace_switches_after(base::Time kept_until, const std::vector<bus::SwitchEdge>& edges) {
    const auto later =
        std::find_if(edges_.begin(), edges_.end(), [kept_until](const bus::SwitchEdge& e) { return e.time > kept_until; });
    edges_.erase(later, edges_.end());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    while (checkpoints_.size() > 1 && checkpoints_.back().reached > kept_until) checkpoints_.pop_back();
    if (progress_.reached > kept_until) go_back_before(kept_until);
}

std::vector<std::string> FlightPlayer::notes() const {
    std::vector<std::string> notes = switch_notes_;
    for (const bus::LineReport& report : source_->reports())
        notes.push_back(line_note(log_name_, report.line, bus::describe(report.fault)));
    return notes;
}

bus::BusCounters FlightPlayer::counters_of_whole_log() {
    feed_until(last_);
    const bus::BusCounters counters = progress_.assembler.snapshot(last_).counters;
    restart();
    return counters;
}

}  // namespace tedavis::host_sim
