#include "host_sim/flight_test/read_expectation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/read_steps.hpp"

namespace tedavis::host_sim {
namespace {

/// Keys of which a frame has one value.
constexpr std::array<std::string_view, 5> kSingleKeys = {"phase", "phase_source", "design", "alert", "obstacle_alert"};

std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", seconds);
    return text;
}

void read_window(ScriptTable& table, Expectation& expectation) {
    const auto at = table.number("at_s", 0, kLatestTestTime_s), from = table.number("from_s", 0, kLatestTestTime_s),
               to = table.number("to_s", 0, kLatestTestTime_s), after = table.number("after_s", 0, kLatestTestTime_s),
               within = table.number("within_s", 0, kLatestTestTime_s);
    const auto stays = table.boolean("stays");
    if (stays && !table.has("within_s")) table.fault("stays", "'stays' belongs to after_s and within_s; say from_s and to_s");
    expectation.stays = stays.value_or(false);
    const int forms = (table.has("at_s") ? 1 : 0) + (table.has("from_s") || table.has("to_s") ? 1 : 0) +
                      (table.has("after_s") || table.has("within_s") ? 1 : 0);
    if (forms != 1) return table.fault("at_s", "an [[expect]] has one time: at_s, or from_s and to_s, or after_s and within_s");
    if (table.has("from_s") != table.has("to_s")) return table.fault("from_s", "from_s and to_s belong together; say both");
    if (table.has("after_s") && !table.has("within_s"))
        return table.fault("after_s", "after_s needs within_s, the seconds in which it must be reached");
    if (at) expectation.from_s = expectation.to_s = *at;
    if (from && to) {
        expectation.kind = WindowKind::during;
        expectation.from_s = *from;
        expectation.to_s = *to;
        if (*to < *from) table.fault("to_s", "to_s lies before from_s; exchange them");
    }
    if (within) {
        expectation.kind = WindowKind::within;
        expectation.from_s = after.value_or(0);
        expectation.to_s = expectation.from_s + *within;
    }
}

bool is_part_of(std::string_view phase, std::string_view other) {
    return phase == other ||
           (phase.size() > other.size() && phase.substr(0, other.size()) == other && phase[other.size()] == '.');
}

/// "pitch valid" in two words.
std::pair<std::string_view, std::string_view> subject_and_state(std::string_view expected) {
    const std::size_t blank = expected.rfind(' ');
    return {expected.substr(0, blank), expected.substr(blank + 1)};
}

/// "pitch.lost" as {"pitch", "lost"}; a flag that is not of a signal has a subject that no signal has.
std::pair<std::string_view, std::string_view> subject_and_state_of_flag(std::string_view flag) {
    const std::size_t dot = flag.rfind('.');
    if (dot == std::string_view::npos || flight::signal_from_name(flag.substr(0, dot)) == flight::Signal::count_)
        return {flag, {}};
    return {flag.substr(0, dot), flag.substr(dot + 1)};
}

/// Of conditions that say a subject and its state; nothing of others.
std::optional<std::pair<std::string_view, std::string_view>> stated_by(const FrameCondition& condition) {
    if (condition.key == "signals" || condition.key == "effects" || condition.key == "elements")
        return subject_and_state(condition.expected);
    if (condition.key == "flags") return subject_and_state_of_flag(condition.expected);
    return std::nullopt;
}

bool are_opposite_texts(const FrameCondition& a, const FrameCondition& b) {
    return a.key == "text" && b.key == "text" && (a.expected == "no " + b.expected || b.expected == "no " + a.expected);
}

bool are_opposite_flags(const FrameCondition& there, const FrameCondition& gone) {
    return there.key == "flags" && gone.key == "no_flags" && gone.expected == kNoFlag + there.expected;
}

/// A value is shown only of a signal that is valid or stale.
bool asks_for_value_of_lost(const FrameCondition& value, const FrameCondition& state) {
    const auto stated = stated_by(state);
    if (!value.range || value.signal != state.signal || !stated) return false;
    return stated->second == "lost" || stated->second == "missing" || stated->second == "invalid";
}

/// Ranges of one signal without a common value, in whatever units.
bool are_separate_ranges(const FrameCondition& a, const FrameCondition& b) {
    constexpr double kRounding = 1e-9;
    if (!a.range || !b.range || a.signal != b.signal) return false;
    const double low = std::max(a.range->low, b.range->low), high = std::min(a.range->high, b.range->high);
    return low - high > kRounding * (std::abs(low) + std::abs(high));
}

/// As phases are arbitrated: without a source there is none, and switches and messages state one. The motion may state that there
/// is none, as in level flight near the ground, and that is held, too.
bool are_phase_and_other_source(const FrameCondition& phase, const FrameCondition& source) {
    if (phase.key != "phase" || source.key != "phase_source") return false;
    if (phase.expected != "unknown") return source.expected == "none";
    return source.expected == "switch" || source.expected == "can";
}

/// Told in one order.
bool excludes(const FrameCondition& a, const FrameCondition& b) {
    return are_opposite_flags(a, b) || asks_for_value_of_lost(a, b) || are_phase_and_other_source(a, b);
}

bool can_both_hold(const FrameCondition& a, const FrameCondition& b) {
    if (excludes(a, b) || excludes(b, a) || are_opposite_texts(a, b) || are_separate_ranges(a, b)) return false;
    const auto of_a = stated_by(a), of_b = stated_by(b);
    const bool is_one_kind = (a.key == "elements") == (b.key == "elements");  // their names are also those of signals
    if (of_a && of_b) return !is_one_kind || of_a->first != of_b->first || of_a->second == of_b->second;
    const bool is_single = std::find(kSingleKeys.begin(), kSingleKeys.end(), a.key) != kSingleKeys.end();
    if (a.key != b.key || !is_single) return true;
    return is_part_of(a.expected, b.expected) || is_part_of(b.expected, a.expected);
}

bool lies_in(const Expectation& inner, const Expectation& outer) {
    return outer.kind == WindowKind::during && outer.from_s <= inner.from_s && inner.to_s <= outer.to_s;
}

/// Whether both must hold in one frame. One that must be reached must hold somewhere in its time, and in its last frame if it
/// stays.
bool overlap(const Expectation& a, const Expectation& b) {
    const auto must_hold_at_once = [](const Expectation& reached, const Expectation& other) {
        const bool has_its_end =
            reached.stays && other.kind != WindowKind::within && other.from_s <= reached.to_s && other.to_s >= reached.to_s;
        return lies_in(reached, other) || has_its_end;
    };
    if (a.kind == WindowKind::within) return must_hold_at_once(a, b);
    if (b.kind == WindowKind::within) return must_hold_at_once(b, a);
    return a.from_s <= b.to_s && b.from_s <= a.to_s;
}

/// "phase cruise"; "no_flags pitch.lost", whose key says already that it is not there.
std::string words_of_condition(const FrameCondition& condition) {
    const bool is_no_flag = condition.key == "no_flags";
    return condition.key + " " + (is_no_flag ? condition.expected.substr(std::string_view(kNoFlag).size()) : condition.expected);
}

/// Two conditions of one expectation.
void find_own_contradictions(const Expectation& expectation, ScriptTable& table) {
    for (std::size_t n = 1; n < expectation.conditions.size(); ++n)
        for (std::size_t before = 0; before < n; ++before) {
            const FrameCondition &a = expectation.conditions[n], &b = expectation.conditions[before];
            if (can_both_hold(a, b)) continue;
            table.fault(a.key, words_of_condition(a) + " contradicts " + words_of_condition(b) + "; correct one of them");
        }
}

void find_contradiction(const Expectation& later, const Expectation& earlier, ScriptFaults& faults) {
    for (const FrameCondition& a : later.conditions)
        for (const FrameCondition& b : earlier.conditions)
            if (!can_both_hold(a, b))
                return faults.add(later.file, later.line,
                                  words_of_condition(a) + " contradicts " + words_of_condition(b) + " of " + earlier.file + ":" +
                                      std::to_string(earlier.line) + " at the same time; correct one of them");
}

}  // namespace

Expectation read_expectation(ScriptTable& table, const TestedDisplay& display, ScriptFaults& faults) {
    Expectation expectation;
    expectation.file = table.file();
    expectation.line = table.line();
    expectation.name = table.text("name").value_or("");
    read_window(table, expectation);
    expectation.conditions = read_conditions(table, display, faults);
    table.finish();
    if (expectation.name.empty()) expectation.name = words_of_expectation(expectation);
    find_own_contradictions(expectation, table);
    return expectation;
}

std::string words_of_expectation(const Expectation& expectation) {
    std::string words = seconds_text(expectation.from_s);
    if (expectation.kind == WindowKind::during) words += " to " + seconds_text(expectation.to_s);
    if (expectation.kind == WindowKind::within)
        words = std::string(expectation.stays ? "from within " : "within ") +
                seconds_text(expectation.to_s - expectation.from_s) + " after " + words;
    std::string what;
    for (const FrameCondition& condition : expectation.conditions)
        what += (what.empty() ? ": " : ", ") + words_of_condition(condition);
    return words + what;
}

void find_contradictions(const std::vector<Expectation>& expectations, ScriptFaults& faults) {
    for (std::size_t n = 1; n < expectations.size(); ++n)
        for (std::size_t before = 0; before < n; ++before)
            if (overlap(expectations[n], expectations[before])) find_contradiction(expectations[n], expectations[before], faults);
}

}  // namespace tedavis::host_sim
