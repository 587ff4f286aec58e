#include "host_sim/flight_test/read_expectation.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

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

bool can_both_hold(const FrameCondition& a, const FrameCondition& b) {
    const bool is_flag_pair = (a.key == "flags" && b.key == "no_flags") || (a.key == "no_flags" && b.key == "flags");
    if (is_flag_pair) return a.expected != b.expected;
    const bool is_single = std::find(kSingleKeys.begin(), kSingleKeys.end(), a.key) != kSingleKeys.end();
    if (a.key != b.key || !is_single) return true;
    return is_part_of(a.expected, b.expected) || is_part_of(b.expected, a.expected);
}

bool overlap(const Expectation& a, const Expectation& b) {
    const bool are_fixed = a.kind != WindowKind::within && b.kind != WindowKind::within;
    return are_fixed && a.from_s <= b.to_s && b.from_s <= a.to_s;
}

void find_contradiction(const Expectation& later, const Expectation& earlier, ScriptFaults& faults) {
    for (const FrameCondition& a : later.conditions)
        for (const FrameCondition& b : earlier.conditions)
            if (!can_both_hold(a, b))
                return faults.add(later.file, later.line,
                                  a.key + " " + a.expected + " contradicts " + b.key + " " + b.expected + " of " + earlier.file +
                                      ":" + std::to_string(earlier.line) + " at the same time; correct one of them");
}

}  // namespace

Expectation read_expectation(ScriptTable& table, const std::vector<std::string>& designs, ScriptFaults& faults) {
    Expectation expectation;
    expectation.file = table.file();
    expectation.line = table.line();
    expectation.name = table.text("name").value_or("");
    read_window(table, expectation);
    expectation.conditions = read_conditions(table, designs, faults);
    table.finish();
    if (expectation.name.empty()) expectation.name = words_of_expectation(expectation);
    for (const FrameCondition& a : expectation.conditions)
        for (const FrameCondition& b : expectation.conditions)
            if (a.key == "flags" && !can_both_hold(a, b))
                table.fault("no_flags", "'" + a.expected + "' must be there and must not; remove it from flags or no_flags");
    return expectation;
}

std::string words_of_expectation(const Expectation& expectation) {
    std::string words = seconds_text(expectation.from_s);
    if (expectation.kind == WindowKind::during) words += " to " + seconds_text(expectation.to_s);
    if (expectation.kind == WindowKind::within)
        words = "within " + seconds_text(expectation.to_s - expectation.from_s) + " after " + words;
    std::string what;
    for (const FrameCondition& condition : expectation.conditions)
        what += (what.empty() ? ": " : ", ") + condition.key + " " + condition.expected;
    return words + what;
}

void find_contradictions(const std::vector<Expectation>& expectations, ScriptFaults& faults) {
    for (std::size_t n = 1; n < expectations.size(); ++n)
        for (std::size_t before = 0; before < n; ++before)
            if (overlap(expectations[n], expectations[before])) find_contradiction(expectations[n], expectations[before], faults);
}

}  // namespace tedavis::host_sim
