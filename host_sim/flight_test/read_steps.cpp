#include "host_sim/flight_test/read_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bus/candump/candump_line.hpp"
#include "host_sim/calendar_time.hpp"
#include "host_sim/flight_test/nearest_names.hpp"
#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/sent_message.hpp"
#include "host_sim/flight_test/signal_value.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kPhaseGroup = "phase";
constexpr const char* kClockGroup = "clock";

struct KeyFactor {
    const char* suffix;
    double factor;
};
constexpr KeyFactor kLengths[] = {{"_m", 1}, {"_ft", base::kMetresPerFoot}};
constexpr KeyFactor kSpeeds[] = {{"_mps", 1}, {"_kt", base::kMpsPerKnot}};
constexpr KeyFactor kClimbs[] = {{"_mps", 1}, {"_fpm", base::kMpsPerFootPerMinute}};
constexpr KeyFactor kAngles[] = {{"_deg", base::kRadiansPerDegree}};

/// The value in SI of the key with one of the units; `low` and `high` are SI as well.
template <std::size_t count>
std::optional<double> number_of_units(ScriptTable& table, const std::string& name, const KeyFactor (&units)[count], double low,
                                      double high) {
    std::optional<double> value;
    for (const KeyFactor& unit : units) {
        const std::string key = name + unit.suffix;
        const auto stated = table.number(key, low / unit.factor, high / unit.factor);
        if (stated && value) table.fault(key, "'" + key + "' says what another key says in another unit; remove one");
        if (stated) value = *stated * unit.factor;
    }
    return value;
}

/// The value in SI; nothing after a fault.
std::optional<double> read_target_value(const ScriptValue::Entry& entry, const StatedSignalUnit& unit, ScriptFaults& faults) {
    const ScriptValue& value = entry.second;
    const bool is_number = value.kind == ScriptValue::Kind::number && std::isfinite(value.number);
    const std::string message =
        is_number ? fault_of_value(entry.first, unit, value.number) : "'" + entry.first + "' must be a finite number";
    if (!message.empty()) faults.add(value.file, value.line, message + (is_number ? "; send them with frame = \"...\"" : ""));
    if (!message.empty()) return std::nullopt;
    return unit.to_si(value.number);
}

std::vector<SignalTarget> read_targets(ScriptTable& table, std::string_view key, const bus::BusSettings& bus,
                                       ScriptFaults& faults) {
    std::vector<SignalTarget> targets;
    for (const ScriptValue::Entry* const entry : table.entries(key)) {
        std::string message;
        const auto unit = read_signal_key(entry->first, message);
        if (unit && is_stated(bus.messages, unit->signal))
            message = "the bus file states a [[message]] of its own for '" + entry->first + "'; send it with frame = \"...\"";
        if (unit &&
            std::any_of(targets.begin(), targets.end(), [&](const SignalTarget& one) { return one.signal == unit->signal; }))
            message = "'" + entry->first + "' says what another key of '" + std::string(key) + "' says; remove one";
        if (!message.empty())
            faults.add(entry->second.file, entry->second.line, message);
        else if (const auto si = read_target_value(*entry, *unit, faults))
            targets.push_back({unit->signal, *si});
    }
    return targets;
}

bool has_signal(const std::vector<flight::Signal>& signals, flight::Signal signal) {
    return std::find(signals.begin(), signals.end(), signal) != signals.end();
}

std::string twice(flight::Signal signal, const char* a, const char* b) {
    return std::string("'") + flight::to_string(signal) + "' is in " + a + " and in " + b + " of one [[step]]; remove one";
}

/// One signal of which a step says two things that exclude each other; told once for each pair of keys.
void find_signals_twice(ScriptTable& table, const TestStep& step) {
    const std::pair<const char*, const std::vector<flight::Signal>*> kLists[] = {
        {"stop", &step.stop}, {"send", &step.send}, {"invalid", &step.invalid}};
    for (std::size_t n = 1; n < std::size(kLists); ++n)
        for (std::size_t before = 0; before < n; ++before)
            for (const flight::Signal signal : *kLists[n].second)
                if (has_signal(*kLists[before].second, signal)) {
                    table.fault(kLists[n].first, twice(signal, kLists[before].first, kLists[n].first));
                    break;
                }
    const auto compare = [&](const char* key, const std::vector<SignalTarget>& targets) {
        for (const SignalTarget& target : targets)
            if (has_signal(step.stop, target.signal)) table.fault(key, twice(target.signal, key, "stop"));
    };
    compare("hold", step.hold);
    compare("ramp", step.ramp);
    for (const SignalTarget& held : step.hold)
        for (const SignalTarget& ramp : step.ramp)
            if (held.signal == ramp.signal) table.fault("ramp", twice(held.signal, "hold", "ramp"));
    if (step.stops_clock && step.sends_clock) table.fault("send", "'clock' is in stop and in send of one [[step]]; remove one");
    if (step.stops_phase && step.phase) table.fault("phase", "'phase' is stated and stopped in one [[step]]; remove one");
}

std::vector<flight::Signal> read_signal_names(ScriptTable& table, const char* key, bool* phase, bool* clock) {
    std::vector<flight::Signal> signals;
    for (const std::string& name : table.texts(key)) {
        if (phase != nullptr && (name == kPhaseGroup || name == "all")) *phase = true;
        if (clock != nullptr && (name == kClockGroup || name == "all")) *clock = true;
        const std::vector<flight::Signal> named = signals_named(name);
        signals.insert(signals.end(), named.begin(), named.end());
        const bool is_known =
            !named.empty() || (phase != nullptr && name == kPhaseGroup) || (clock != nullptr && name == kClockGroup);
        if (!is_known) static_cast<void>(place_among(table, key, name, signal_group_names()));
    }
    return signals;
}

void read_phase_message(ScriptTable& table, TestStep& step) {
    step.phase_valid = table.boolean("phase_valid").value_or(true);
    if (const auto origin = table.text("phase_origin"))
        if (const auto place = place_among(table, "phase_origin", *origin, phase_origin_names()))
            step.phase_origin = static_cast<bus::PhaseOrigin>(*place);
    const auto name = table.text("phase");
    if (!name && (table.has("phase_valid") || table.has("phase_origin")))
        table.fault("phase_valid", "a message has a phase; say phase = \"cruise\" or the like, too");
    if (!name) return;
    const flight::ParsedPhase parsed = flight::phase_from_name(*name);
    if (parsed.ok)
        step.phase = parsed.phase;
    else
        static_cast<void>(place_among(table, "phase", *name, phase_names()));
}

/// A line's name, alone active; or a phase, whose pattern the panel has.
void read_switch(ScriptTable& table, const bus::SwitchConfig& panel, TestStep& step) {
    const auto name = table.text("switch");
    if (!name || panel.lines.empty()) return;
    const std::vector<std::string> names = panel_line_names(panel);
    std::optional<std::uint32_t> high;
    const auto line = std::find(names.begin(), names.end(), *name);
    if (line != names.end()) high = std::uint32_t{1} << static_cast<unsigned>(line - names.begin());
    for (const bus::SwitchPattern& pattern : panel.patterns)
        if (!high && phase_text(pattern.phase) == *name) high = pattern.high;
    if (!high)
        return table.fault("switch",
                           "'switch': the panel has no line and no pattern '" + *name + "'; say " + nearest_names(*name, names));
    for (std::size_t n = 0; n < names.size(); ++n)
        if ((panel.phase_lines() >> n & 1u) != 0 || (*high >> n & 1u) != 0) step.lines.push_back({n, (*high >> n & 1u) != 0});
}

std::optional<std::size_t> read_line_name(ScriptTable& table, const char* key, const std::string& name,
                                          const bus::SwitchConfig& panel) {
    if (panel.lines.empty()) return std::nullopt;
    return place_among(table, key, name, panel_line_names(panel));
}

void read_lines(ScriptTable& table, const bus::SwitchConfig& panel, ScriptFaults& faults, TestStep& step) {
    for (const ScriptValue::Entry* const entry : table.entries("lines")) {
        const auto line = read_line_name(table, "lines", entry->first, panel);
        const bool is_level =
            entry->second.kind == ScriptValue::Kind::number && (entry->second.number == 0 || entry->second.number == 1);
        if (!is_level)
            faults.add(entry->second.file, entry->second.line, "'" + entry->first + "' must be 0 or 1, the level of the line");
        else if (line)
            step.lines.push_back({*line, entry->second.number == 1});
    }
}

void read_bounce(ScriptTable& table, const bus::SwitchConfig& panel, ScriptFaults& faults, TestStep& step) {
    constexpr double kMaxTimes = 1000, kMaxGap_ms = 10000;
    const ScriptValue* const value = table.take("bounce");
    if (value == nullptr) return;
    ScriptTable bounce(*value, faults);
    const auto name = bounce.text("line");
    const auto times = bounce.number("times", 1, kMaxTimes);
    const auto gap_ms = bounce.number("gap_ms", 0.1, kMaxGap_ms);
    bounce.finish();
    if (times && *times != std::floor(*times)) return bounce.fault("times", "'times' must be a whole number");
    if (!name || !times || !gap_ms)
        return bounce.fault("", "'bounce' says a line, times and gap_ms: { line = \"CRUISE\", times = 5, gap_ms = 3 }");
    if (const auto line = read_line_name(bounce, "line", *name, panel))
        step.bounce = LineBounce{*line, static_cast<std::uint32_t>(*times), *gap_ms / 1000};
}

void read_frames(ScriptTable& table, TestStep& step) {
    for (const std::string& text : table.texts("frame")) {
        bus::CanFrame frame;
        const std::string line = "(0.000000) can0 " + text;
        const bus::CandumpLine parsed = bus::parse_candump_line(line, frame);
        if (parsed.kind == bus::LineKind::frame)
            step.frames.push_back(frame);
        else
            table.fault("frame", "'frame': '" + text + "' is no frame as candump writes it (" + bus::describe(parsed.fault) +
                                     "); say for example \"727#0102\"");
    }
}

void read_ramp(ScriptTable& table, const bus::BusSettings& bus, ScriptFaults& faults, TestStep& step) {
    step.ramp = read_targets(table, "ramp", bus, faults);
    const auto over_s = table.number("over_s", 1e-3, kLatestTestTime_s);
    step.over_s = over_s.value_or(0);
    if (table.has("ramp") && !table.has("over_s")) table.fault("ramp", "'ramp' needs over_s, the seconds that it takes");
    if (table.has("over_s") && !table.has("ramp")) table.fault("over_s", "'over_s' belongs to a ramp; say ramp = { ... }, too");
}

/// Standing on the strip of the shipped scenario, or flying over the shipped terrain.
TestStart usual_start(bool stands) {
    TestStart start;
    start.latitude_rad = base::radians(36.607917);
    start.longitude_rad = base::radians(-84.176250);
    start.heading_rad = base::radians(240);
    start.altitude_msl_m = stands ? 347.5 : 1500;
    start.speed_mps = stands ? 0 : 55;
    start.time = *parse_iso8601("2026-06-01T14:00:00Z");
    return start;
}

}  // namespace

std::vector<std::string> panel_line_names(const bus::SwitchConfig& panel) {
    std::vector<std::string> names;
    for (const bus::SwitchLine& line : panel.lines) names.emplace_back(line.name.view());
    return names;
}

TestStart read_start(ScriptTable& table) {
    static const std::vector<std::string> kMotions = {"flying", "standing"};
    constexpr double kHighest_m = 15000, kFastest_mps = 340, kSteepest_mps = 60, kLowest_m = -500;
    const std::string motion = table.text("motion").value_or("flying");
    const bool stands = place_among(table, "motion", motion, kMotions).value_or(0) == 1;
    TestStart start = usual_start(stands);
    const auto put = [](double& value, std::optional<double> stated) { value = stated.value_or(value); };
    put(start.latitude_rad, number_of_units(table, "latitude", kAngles, base::radians(-85), base::radians(85)));
    put(start.longitude_rad, number_of_units(table, "longitude", kAngles, base::radians(-180), base::radians(180)));
    put(start.altitude_msl_m, number_of_units(table, "altitude_msl", kLengths, kLowest_m, kHighest_m));
    put(start.heading_rad, number_of_units(table, "heading", kAngles, 0, base::radians(360)));
    put(start.speed_mps, number_of_units(table, "speed", kSpeeds, 0, kFastest_mps));
    put(start.climb_mps, number_of_units(table, "vertical_speed", kClimbs, -kSteepest_mps, kSteepest_mps));
    start.ground_msl_m = number_of_units(table, "ground_msl", kLengths, kLowest_m, kHighest_m);
    if (const auto time = table.text("utc")) {
        const auto parsed = parse_iso8601(*time);
        if (!parsed) table.fault("utc", "'utc' must be a time in quotes such as \"2026-06-01T14:00:00Z\"");
        start.time = parsed.value_or(start.time);
    }
    table.finish();
    return start;
}

TestStep read_step(ScriptTable& table, const bus::BusSettings& bus, const bus::SwitchConfig& panel, ScriptFaults& faults) {
    TestStep step;
    step.file = table.file();
    step.line = table.line();
    if (!table.has("at_s")) table.fault("", "this [[step]] has no time; say at_s = 5");
    step.at_s = table.number("at_s", 0, kLatestTestTime_s).value_or(0);
    step.hold = read_targets(table, "hold", bus, faults);
    read_ramp(table, bus, faults, step);
    step.stop = read_signal_names(table, "stop", &step.stops_phase, &step.stops_clock);
    step.send = read_signal_names(table, "send", nullptr, &step.sends_clock);
    step.invalid = read_signal_names(table, "invalid", nullptr, nullptr);
    read_phase_message(table, step);
    read_switch(table, panel, step);
    read_lines(table, panel, faults, step);
    read_bounce(table, panel, faults, step);
    read_frames(table, step);
    table.finish();
    find_signals_twice(table, step);
    return step;
}

}  // namespace tedavis::host_sim
