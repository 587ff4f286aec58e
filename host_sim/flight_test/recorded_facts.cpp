#include "host_sim/flight_test/recorded_facts.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/signal_value.hpp"
#include "render_core/effects/effect_table.hpp"
#include "render_core/policy/flag_table.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::array<const char*, 3> kRecordedEffectStates = {"run", "replaced", "skipped"};

/// Those of signals repeat what the signals' states say.
bool is_recorded_flag(std::string_view name) {
    static const std::set<std::string, std::less<>> kNames = [] {
        std::set<std::string, std::less<>> names;
        for (const policy::FlagRow& row : policy::flag_rows()) names.emplace(row.name);
        return names;
    }();
    return kNames.find(name) != kNames.end();
}

bool is_recorded_effect(std::string_view name) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (effects::row_of(static_cast<effects::Effect>(n)).name == name) return true;
    return false;
}

void add_signals(const display::FrameRecord& record, std::vector<RecordedFact>& facts) {
    for (std::size_t n = 0; n < record.signals.size(); ++n)
        facts.push_back(
            {FactKind::signal, flight::to_string(static_cast<flight::Signal>(n)), base::to_string(record.signals[n])});
}

}  // namespace

std::vector<RecordedFact> facts_of(const ObservedFrame& frame, const WatchedAlerts& alerts) {
    const display::FrameRecord& record = frame.record;
    std::vector<RecordedFact> facts = {{FactKind::phase, "", exact_phase_text(record.phase.phase)},
                                       {FactKind::phase_source, "", flight::to_string(record.phase.source)},
                                       {FactKind::design, "", std::string(record.design.view())}};
    if (alerts.terrain) facts.push_back({FactKind::alert, "", alert_text(frame)});
    if (alerts.obstacles) facts.push_back({FactKind::obstacle_alert, "", obstacle_alert_text(frame)});
    add_signals(record, facts);
    for (const display::Name& flag : record.flags)
        if (is_recorded_flag(flag.view())) facts.push_back({FactKind::flag, std::string(flag.view()), kFlagThere});
    for (const display::EffectRecord& effect : record.effects)
        if (is_recorded_effect(effect.name.view()))
            facts.push_back({FactKind::effect, std::string(effect.name.view()),
                             kRecordedEffectStates[static_cast<std::size_t>(effect.state)]});
    return facts;
}

void FactTracks::take(const ObservedFrame& frame) {
    if (frames_ == 0) first_s_ = frame.time_s;
    ++frames_;
    for (const RecordedFact& fact : facts_of(frame, alerts_)) extend(fact, frame.time_s);
    end_unseen(frame.time_s);
    last_s_ = frame.time_s;
}

void FactTracks::begin(Track& track, const RecordedFact& fact, double time_s) {
    track.spans.push_back({fact, time_s, time_s, frames_ == 1, false});
}

void FactTracks::extend(const RecordedFact& fact, double time_s) {
    Track& track = tracks_[{fact.kind, fact.name}];
    if (track.spans.empty() && fact.kind == FactKind::flag && frames_ > 1)
        track.spans.push_back({{fact.kind, fact.name, kFlagGone}, first_s_, last_s_, true, false});
    const bool goes_on = !track.spans.empty() && track.spans.back().fact.value == fact.value && track.last_frame + 1 == frames_;
    if (!goes_on) begin(track, fact, time_s);
    track.spans.back().last_s = time_s;
    track.last_frame = frames_;
}

/// Flags that are not there any more.
void FactTracks::end_unseen(double time_s) {
    for (auto& [key, track] : tracks_) {
        const auto& [kind, name] = key;
        if (kind == FactKind::flag && track.last_frame != frames_) extend({kind, name, kFlagGone}, time_s);
    }
}

std::vector<FactSpan> FactTracks::spans() const {
    std::vector<FactSpan> all;
    for (const auto& [key, track] : tracks_) {
        const bool was_never_there = track.spans.size() == 1 && track.spans.front().fact.value == "missing";
        if (std::get<FactKind>(key) == FactKind::signal && was_never_there) continue;
        for (const FactSpan& span : track.spans) all.push_back(span);
        all.back().to_end = track.last_frame == frames_;
    }
    return all;
}

}  // namespace tedavis::host_sim
