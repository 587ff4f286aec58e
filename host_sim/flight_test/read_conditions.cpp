#include "host_sim/flight_test/read_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "host_sim/flight_test/contract_condition.hpp"
#include "host_sim/flight_test/nearest_names.hpp"
#include "host_sim/flight_test/signal_value.hpp"
#include "host_sim/flight_test/text_condition.hpp"
#include "render_core/effects/effect_table.hpp"
#include "render_core/policy/element_texts.hpp"
#include "render_core/policy/flag_table.hpp"

namespace tedavis::host_sim {
namespace {

using base::SignalState;
using flight::PhaseSource;
using Conditions = std::vector<FrameCondition>;

constexpr std::array<PhaseSource, 5> kTestedSources = {PhaseSource::none, PhaseSource::held, PhaseSource::motion,
                                                       PhaseSource::can, PhaseSource::switches};
constexpr std::array<SignalState, 5> kTestedStates = {SignalState::missing, SignalState::valid, SignalState::stale,
                                                      SignalState::lost, SignalState::invalid};
const std::vector<std::string> kAlertNames = {"none", "caution", "warning", "not_watching"};
constexpr std::size_t kNoAlert = 0, kNotWatching = 3;
constexpr std::size_t kElementShows = static_cast<std::size_t>(policy::ElementShow::absent) + 1;
const std::vector<std::string> kEffectStateNames = {"run", "replaced", "skipped"};

template <class Values>
std::vector<std::string> names_of_values(const Values& values) {
    std::vector<std::string> names;
    for (const auto value : values) names.emplace_back(to_string(value));
    return names;
}

/// "approach", "approach.final" and "approach.none", and so on.
std::vector<std::string> expected_phase_names() {
    std::vector<std::string> names = phase_names();
    for (const std::string& name : phase_names()) {
        const std::string exact = exact_phase_text(flight::phase_from_name(name).phase);
        if (exact != name) names.push_back(exact);
    }
    return names;
}

bool has_flag(const display::FrameRecord& record, const std::string& name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [&](const display::Name& flag) { return flag.view() == name; });
}

/// A scenario stands for its sub-phases, too, unless it is said that it has none.
void read_phase_condition(ScriptTable& table, Conditions& conditions) {
    const auto name = table.text("phase");
    if (!name) return;
    if (!place_among(table, "phase", *name, expected_phase_names())) return;
    const bool has_none = name->find(kNoSubPhase) != std::string::npos;
    const flight::FlightPhase phase = flight::phase_from_name(name->substr(0, name->find(kNoSubPhase))).phase;
    conditions.push_back({"phase", *name, [phase, is_exact = has_none || phase.sub_phase != 0](const ObservedFrame& frame) {
                              const flight::FlightPhase found = frame.record.phase.phase;
                              const bool holds = is_exact ? found == phase : found.scenario == phase.scenario;
                              return Observation{holds, phase_text(found), words_of_phase(frame.record.phase)};
                          }});
}

void read_source_condition(ScriptTable& table, Conditions& conditions) {
    const auto name = table.text("phase_source");
    if (!name) return;
    const auto place = place_among(table, "phase_source", *name, names_of_values(kTestedSources));
    if (!place) return;
    conditions.push_back({"phase_source", *name, [source = kTestedSources[*place]](const ObservedFrame& frame) {
                              const flight::PhaseStatus& found = frame.record.phase;
                              return Observation{found.source == source, flight::to_string(found.source), words_of_phase(found)};
                          }});
}

void read_design_condition(ScriptTable& table, const std::vector<std::string>& designs, Conditions& conditions) {
    const auto name = table.text("design");
    if (!name || !place_among(table, "design", *name, designs)) return;
    conditions.push_back({"design", *name, [design = *name](const ObservedFrame& frame) {
                              const std::string found(frame.record.design.view());
                              return Observation{found == design, found, words_of_phase(frame.record.phase)};
                          }});
}

/// "pitch.stale" repeats the state of a signal.
std::optional<flight::Signal> signal_of_flag(const std::string& name) {
    const flight::Signal signal = flight::signal_from_name(name.substr(0, name.find('.')));
    return signal == flight::Signal::count_ ? std::nullopt : std::optional(signal);
}

void read_flag_conditions(ScriptTable& table, const char* key, bool is_there, Conditions& conditions) {
    const std::vector<std::string> known = record_flag_names();
    for (const std::string& name : table.texts(key)) {
        if (!place_among(table, key, name, known)) continue;
        conditions.push_back({key, (is_there ? "" : kNoFlag) + name,
                              [name, is_there](const ObservedFrame& frame) {
                                  return Observation{has_flag(frame.record, name) == is_there, list_of_flags(frame.record),
                                                     words_of_phase(frame.record.phase)};
                              },
                              signal_of_flag(name)});
    }
}

void read_signal_conditions(ScriptTable& table, ScriptFaults& faults, Conditions& conditions) {
    for (const ScriptValue::Entry* const entry : table.entries("signals")) {
        const flight::Signal signal = flight::signal_from_name(entry->first);
        const auto& states = names_of_values(kTestedStates);
        const auto state = std::find(states.begin(), states.end(), entry->second.text);
        if (signal == flight::Signal::count_)
            faults.add(entry->second.file, entry->second.line,
                       "'signals': there is no '" + entry->first + "'; say " + nearest_names(entry->first, bus_signal_names()));
        else if (state == states.end())
            faults.add(entry->second.file, entry->second.line,
                       "'" + entry->first + "' must be missing, valid, stale, lost or invalid");
        else
            conditions.push_back(
                {"signals", entry->first + " " + *state,
                 [signal, wanted = kTestedStates[static_cast<std::size_t>(state - states.begin())]](const ObservedFrame& frame) {
                     const SignalState found = frame.record.signals[static_cast<std::size_t>(signal)];
                     return Observation{found == wanted, std::string(flight::to_string(signal)) + " " + base::to_string(found),
                                        list_of_flags(frame.record)};
                 },
                 signal});
    }
}

Observation observe_effect(const ObservedFrame& frame, const std::string& name, std::size_t state) {
    for (const display::EffectRecord& effect : frame.record.effects)
        if (effect.name.view() == name)
            return {static_cast<std::size_t>(effect.state) == state,
                    name + " " + kEffectStateNames[static_cast<std::size_t>(effect.state)], std::string(effect.reason.view())};
    return {false, name + " is not asked for", "the design does not use it"};
}

void read_effect_conditions(ScriptTable& table, ScriptFaults& faults, Conditions& conditions) {
    std::vector<std::string> known;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        known.emplace_back(effects::row_of(static_cast<effects::Effect>(n)).name);
    for (const ScriptValue::Entry* const entry : table.entries("effects")) {
        const auto state = std::find(kEffectStateNames.begin(), kEffectStateNames.end(), entry->second.text);
        if (std::find(known.begin(), known.end(), entry->first) == known.end())
            faults.add(entry->second.file, entry->second.line,
                       "'effects': there is no '" + entry->first + "'; say " + nearest_names(entry->first, known));
        else if (state == kEffectStateNames.end())
            faults.add(entry->second.file, entry->second.line, "'" + entry->first + "' must be run, replaced or skipped");
        else
            conditions.push_back({"effects", entry->first + " " + *state,
                                  [name = entry->first, place = static_cast<std::size_t>(state - kEffectStateNames.begin())](
                                      const ObservedFrame& frame) { return observe_effect(frame, name, place); }});
    }
}

template <class Value>
std::vector<std::string> policy_names(Value end) {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < static_cast<std::size_t>(end); ++n) names.emplace_back(policy::name_of(static_cast<Value>(n)));
    return names;
}

/// elements = { heading = "substituted" }: how the symbology shows a value.
void read_element_conditions(ScriptTable& table, ScriptFaults& faults, Conditions& conditions) {
    const std::vector<std::string> names = policy_names(policy::Element::count_);
    const std::vector<std::string> shows = policy_names(static_cast<policy::ElementShow>(kElementShows));
    for (const ScriptValue::Entry* const entry : table.entries("elements")) {
        const auto& [name, value] = *entry;
        const auto element = std::find(names.begin(), names.end(), name);
        if (element == names.end()) {
            faults.add(value.file, value.line, "'elements': there is no '" + name + "'; say " + nearest_names(name, names));
        } else if (std::find(shows.begin(), shows.end(), value.text) == shows.end()) {
            faults.add(value.file, value.line, "'" + name + "' must be normal, substituted, flagged, failed or absent");
        } else {
            const auto place = static_cast<std::size_t>(element - names.begin());
            conditions.push_back(
                {"elements", name + " " + value.text, [name = name, show = value.text, place](const ObservedFrame& frame) {
                     const std::string found(policy::name_of(frame.record.elements[place]));
                     return Observation{found == show, name + " " + found, list_of_flags(frame.record)};
                 }});
        }
    }
}

std::string words_of_watch(const ObservedFrame& frame, bool is_watching) {
    const display::AlertRecord& alerts = frame.record.alerts;
    if (!alerts.is_watching)
        return "no alert is possible here: standing, at a runway, high above, or without position or terrain";
    if (!is_watching) return "no alert is possible here: the scene has no obstacles";
    char text[96];
    std::snprintf(text, sizeof text, "%.0f m above the terrain, %.0f m must be kept", alerts.height_above_terrain_m,
                  alerts.clearance_m);
    return text;
}

bool watches_obstacles(const ObservedFrame& frame) { return frame.record.alerts.is_watching && frame.has_obstacles; }

/// "none" is said of a display that watches; without data, or where it does not, there could be no other.
std::string name_of_alert(policy::TerrainAhead level, bool is_watching) {
    const auto stated = static_cast<std::size_t>(level);
    return kAlertNames[stated == kNoAlert && !is_watching ? kNotWatching : stated];
}

void read_alert_conditions(ScriptTable& table, Conditions& conditions) {
    const auto read = [&](const char* key, auto observe) {
        const auto name = table.text(key);
        if (!name || !place_among(table, key, *name, kAlertNames)) return;
        conditions.push_back({key, *name, [observe, wanted = *name](const ObservedFrame& frame) {
                                  Observation observation = observe(frame);
                                  observation.holds = observation.found == wanted;
                                  return observation;
                              }});
    };
    read("alert", [](const ObservedFrame& frame) {
        return Observation{false, alert_text(frame), words_of_watch(frame, frame.record.alerts.is_watching)};
    });
    read("obstacle_alert", [](const ObservedFrame& frame) {
        return Observation{false, obstacle_alert_text(frame), words_of_watch(frame, watches_obstacles(frame))};
    });
}

/// The two numbers of "[89, 91]", SI, the lower one first.
std::optional<SignalRange> read_limits(const ScriptValue::Entry& entry, const StatedSignalUnit& unit, std::string& message) {
    const std::vector<ScriptValue>& items = entry.second.items;
    const bool are_two = entry.second.kind == ScriptValue::Kind::list && items.size() == 2 &&
                         items[0].kind == ScriptValue::Kind::number && items[1].kind == ScriptValue::Kind::number;
    if (!are_two || !(items[0].number <= items[1].number)) {
        message = "'" + entry.first + "' must be two numbers, the lowest and the highest value: [89, 91]";
        if (are_two && is_direction(unit.signal)) message += "; a range does not pass north, so say its part on one side";
        return std::nullopt;
    }
    message = fault_of_range(entry.first, unit, items[0].number, items[1].number);
    return message.empty() ? std::optional(SignalRange{unit.to_si(items[0].number), unit.to_si(items[1].number)}) : std::nullopt;
}

Observation observe_value(const ObservedFrame& frame, const StatedSignalUnit& unit, const SignalRange& range) {
    const double value = frame.values[unit.signal];
    const SignalState state = frame.record.signals[static_cast<std::size_t>(unit.signal)];
    const bool is_shown = state == SignalState::valid || state == SignalState::stale;
    char found[48] = "no value";
    if (is_shown && !std::isnan(value)) std::snprintf(found, sizeof found, "%.6g", (value - unit.offset) / unit.factor);
    return {is_shown && value >= range.low && value <= range.high, found, std::string("the signal is ") + base::to_string(state)};
}

/// values = { indicated_airspeed_kt = [89, 91] }.
void read_value_conditions(ScriptTable& table, ScriptFaults& faults, Conditions& conditions) {
    for (const ScriptValue::Entry* const entry : table.entries("values")) {
        std::string message;
        const auto unit = read_signal_key(entry->first, message);
        const auto range = unit ? read_limits(*entry, *unit, message) : std::nullopt;
        if (!range) {
            faults.add(entry->second.file, entry->second.line, message);
            continue;
        }
        char expected[96];
        std::snprintf(expected, sizeof expected, " %g to %g", entry->second.items[0].number, entry->second.items[1].number);
        const auto observe = [unit = *unit, range = *range](const ObservedFrame& frame) {
            return observe_value(frame, unit, range);
        };
        conditions.push_back({"values", entry->first + expected, observe, unit->signal, {}, range});
    }
}

Observation observe_latency(const ObservedFrame& frame, double limit) {
    if (std::isnan(frame.latency_frames)) return {false, "not known", "no new message has come to the screen for a while"};
    char found[48];
    std::snprintf(found, sizeof found, "%.2f frames", frame.latency_frames);
    return {frame.latency_frames <= limit, found,
            frame.is_latency_to_screen ? "from the bus to the screen, of the oldest message that a picture shows first"
                                       : "age of the newest message"};
}

void read_latency_condition(ScriptTable& table, Conditions& conditions) {
    constexpr double kMaxLatency_frames = 1e6;
    const auto limit = table.number("latency_frames_at_most", 0, kMaxLatency_frames);
    if (!limit) return;
    char expected[48];
    std::snprintf(expected, sizeof expected, "at most %g frames", *limit);
    conditions.push_back({"latency_frames_at_most", expected,
                          [limit = *limit](const ObservedFrame& frame) { return observe_latency(frame, limit); }});
}

/// What asks for nothing would hold always.
void refuse_empty(ScriptTable& table) {
    for (const char* const key : {"flags", "no_flags", "signals", "effects", "elements", "values", "text"}) {
        const ScriptValue* const value = table.take(key);
        if (value == nullptr || !value->items.empty() || !value->entries.empty()) continue;
        const bool is_table = value->kind == ScriptValue::Kind::table && std::string_view(key) != "text";
        if (is_table || value->kind == ScriptValue::Kind::list)
            table.fault(key, std::string("'") + key + "' is empty and asks for nothing; remove it, or say what is expected");
    }
}

}  // namespace

std::string list_of_flags(const display::FrameRecord& record) {
    std::string list;
    for (const display::Name& flag : record.flags) list += (list.empty() ? "" : ", ") + std::string(flag.view());
    return list.empty() ? "no flag" : list;
}

std::string words_of_phase(const flight::PhaseStatus& status) {
    return "phase " + phase_text(status.phase) + " of source " + flight::to_string(status.source) +
           (status.switch_fault ? ", the switch pattern is impossible" : "") + (status.disagreement ? ", sources disagree" : "");
}

std::string phase_text(flight::FlightPhase phase) {
    const std::string sub_phase = flight::sub_phase_name(phase);
    return flight::scenario_name(phase) + (sub_phase.empty() ? "" : "." + sub_phase);
}

std::string exact_phase_text(flight::FlightPhase phase) {
    const bool has_parts = *flight::sub_phase_name({phase.scenario, 1}) != '\0';
    return phase_text(phase) + (phase.sub_phase == 0 && has_parts ? kNoSubPhase : "");
}

std::string alert_text(const ObservedFrame& frame) {
    return name_of_alert(frame.record.alerts.terrain, frame.record.alerts.is_watching);
}

std::string obstacle_alert_text(const ObservedFrame& frame) {
    return name_of_alert(frame.record.alerts.obstacle, watches_obstacles(frame));
}

std::vector<std::string> phase_names() {
    std::vector<std::string> names;
    for (unsigned code = 0; code < 100; ++code)
        if (const auto parsed = flight::phase_from_code(static_cast<std::uint8_t>(code)); parsed.ok)
            names.push_back(phase_text(parsed.phase));
    return names;
}

std::vector<std::string> record_flag_names() {
    std::vector<std::string> names;
    for (const policy::FlagRow& row : policy::flag_rows()) names.emplace_back(row.name);
    for (const std::string& signal : bus_signal_names())
        for (const SignalState state : {SignalState::missing, SignalState::stale, SignalState::lost, SignalState::invalid})
            names.push_back(signal + "." + base::to_string(state));
    return names;
}

std::vector<FrameCondition> read_conditions(ScriptTable& table, const TestedDisplay& display, ScriptFaults& faults) {
    Conditions conditions;
    const std::size_t before = faults.count();
    read_phase_condition(table, conditions);
    read_source_condition(table, conditions);
    read_design_condition(table, display.designs, conditions);
    read_flag_conditions(table, "flags", true, conditions);
    read_flag_conditions(table, "no_flags", false, conditions);
    read_signal_conditions(table, faults, conditions);
    read_effect_conditions(table, faults, conditions);
    read_element_conditions(table, faults, conditions);
    read_value_conditions(table, faults, conditions);
    read_alert_conditions(table, conditions);
    read_latency_condition(table, conditions);
    read_text_conditions(table, faults, conditions);
    read_contract_condition(table, display.picture, conditions);
    refuse_empty(table);
    if (conditions.empty() && faults.count() == before)
        table.fault("", "this [[expect]] asks for nothing; say phase, phase_source, design, flags, signals or the like");
    return conditions;
}

}  // namespace tedavis::host_sim
