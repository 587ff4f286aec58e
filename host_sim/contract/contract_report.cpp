#include "host_sim/contract/contract_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json region_json(const ContractReading& reading) {
    const perception::PixelRegion& box = reading.box;
    const bool has_box = box.right > box.left && box.bottom > box.top;
    return {{"name", reading.region}, {"box", has_box ? Json{box.left, box.top, box.right, box.bottom} : Json()}};
}

Json moment_json(const perception::ConditionMoment& moment, const ContractReading& reading) {
    return {{"time_s", moment.time_s},
            {"value", number_or_null(moment.value)},
            {"region", region_json(reading)},
            {"what", reading.words}};
}

Json condition_json(const JudgedCondition& one) {
    const auto& verdict = one.verdict;
    Json json = {{"condition", one.condition.name},
                 {"measure", kContractMeasureNames[static_cast<std::size_t>(one.condition.measure)]},
                 {"state", kConditionStateNames[static_cast<std::size_t>(one.state)]},
                 {one.condition.limit.is_most ? "most" : "least", one.condition.limit.limit},
                 {"for_s", one.condition.limit.for_s},
                 {"phases", one.condition.phases},
                 {"optional", one.condition.is_optional},
                 {"frames", verdict.measured},
                 {"frames_beyond", verdict.beyond},
                 {"frames_missing", one.missing},
                 {"longest_beyond_s", verdict.longest_s}};
    json["tightest"] = verdict.measured > 0 ? moment_json(verdict.tightest, one.tightest) : Json();
    json["why"] = condition_gap(one);
    json["values"] = Json::array();
    for (const double value : one.values) json["values"].push_back(number_or_null(value));
    return json;
}

Json failure_json(const JudgedCondition& one) {
    const auto& verdict = one.verdict;
    const bool is_broken = one.state == ConditionState::broken;
    const Json nothing;
    return {{"condition", one.condition.name},
            {"measure", kContractMeasureNames[static_cast<std::size_t>(one.condition.measure)]},
            {"time_s", is_broken ? Json(verdict.first.time_s) : nothing},
            {"value", is_broken ? number_or_null(verdict.first.value) : nothing},
            {"limit", one.condition.limit.limit},
            {"region", is_broken ? region_json(one.first) : nothing},
            {"what", is_broken ? Json(one.first.words) : nothing},
            {"worst", is_broken ? moment_json(verdict.worst, one.worst) : nothing},
            {"broken_s", verdict.broken_s},
            {"why", condition_gap(one)}};
}

bool is_rank_measured(const ContractCondition& condition) { return condition.measure == ContractMeasure::obstacle_rank; }

std::string number_text(double value, bool is_rank) {
    if (!std::isfinite(value)) return "none";
    char text[32];
    std::snprintf(text, sizeof text, is_rank ? "%.0f" : "%.3f", value);
    return text;
}

std::string time_text(double time_s) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f s", time_s);
    return text;
}

std::string place_text(const ContractReading& reading) {
    return reading.region + (reading.words.empty() || reading.region.empty() ? "" : ", ") + reading.words;
}

/// What was measured, in words behind the columns.
std::string findings_text(const JudgedCondition& one) {
    const auto& verdict = one.verdict;
    const bool is_rank = is_rank_measured(one.condition);
    if (one.state == ConditionState::broken) {
        const std::string first =
            verdict.first.place == verdict.worst.place
                ? std::string()
                : "first " + number_text(verdict.first.value, is_rank) + " at " + time_text(verdict.first.time_s) + ", ";
        return first + "worst " + number_text(verdict.worst.value, is_rank) + " at " + time_text(verdict.worst.time_s) + " (" +
               place_text(one.worst) + "), broken for " + time_text(verdict.broken_s);
    }
    if (std::string gap = condition_gap(one); !gap.empty()) return gap;
    return "at its tightest " + number_text(verdict.tightest.value, is_rank) + " at " + time_text(verdict.tightest.time_s) +
           " (" + place_text(one.tightest) + "), " +
           (verdict.beyond > 0 ? "beyond it for " + time_text(verdict.longest_s) + " at most, " : std::string()) +
           std::to_string(verdict.measured) + " frames";
}

}  // namespace

std::string limit_text(const ContractCondition& condition) {
    return condition.name + (condition.limit.is_most ? " <= " : " >= ") +
           number_text(condition.limit.limit, is_rank_measured(condition));
}

std::string bound_text(const ContractCondition& condition) {
    return number_text(condition.limit.limit, is_rank_measured(condition)) +
           (condition.limit.is_most ? " is the most" : " is the least");
}

std::string reading_text(const ContractCondition& condition, const ContractReading& reading) {
    return number_text(reading.value, is_rank_measured(condition)) + " (" + place_text(reading) + ")";
}

std::string condition_gap(const JudgedCondition& judged) {
    if (judged.state == ConditionState::missing)
        return std::to_string(judged.missing) + (judged.missing == 1 ? " frame" : " frames") +
               " could not be measured: " + judged.first.words;
    if (judged.state != ConditionState::absent && judged.state != ConditionState::passed) return {};
    std::string phases;
    for (const std::string& phase : judged.condition.phases) phases += (phases.empty() ? " in " : ", ") + phase;
    return "no frame" + phases + " has what it measures";
}

nlohmann::ordered_json contract_json(const JudgedContract& judged) {
    Json failures = Json::array(), conditions = Json::array();
    for (const JudgedCondition& one : judged.conditions) {
        conditions.push_back(condition_json(one));
        if (!one.is_kept()) failures.push_back(failure_json(one));
    }
    return {{"holds", judged.holds()},
            {"failures", failures},
            {"contract", judged.path},
            {"title", judged.title},
            {"run", judged.run},
            {"frames", judged.times_s.size()},
            {"interrupted", judged.interrupted},
            {"times_s", judged.times_s},
            {"conditions", conditions}};
}

std::string contract_text(const JudgedContract& judged) {
    const auto kept = std::count_if(judged.conditions.begin(), judged.conditions.end(),
                                    [](const JudgedCondition& one) { return one.is_kept(); });
    std::string text = judged.run + ": " +
                       (judged.holds()       ? "holds "
                        : judged.interrupted ? "is not shown to hold "
                                             : "does not hold ") +
                       judged.path + " (" + std::to_string(kept) + " of " + std::to_string(judged.conditions.size()) +
                       " conditions, " + std::to_string(judged.times_s.size()) +
                       (judged.interrupted ? " frames, interrupted)" : " frames)");
    for (const JudgedCondition& one : judged.conditions) {
        char state[32];
        std::snprintf(state, sizeof state, "\n  %-18s  ", kConditionStateNames[static_cast<std::size_t>(one.state)]);
        text += state + limit_text(one.condition) + ": " + findings_text(one);
    }
    return text;
}

}  // namespace tedavis::host_sim
