#include "host_sim/accuracy/accuracy_json.hpp"

#include <cstdio>

#include "host_sim/accuracy/chapters_json.hpp"
#include "host_sim/accuracy/knob_json.hpp"
#include "host_sim/accuracy/time_answer.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json conditions_json(const MeasuringConditions& conditions) {
    return {{"version", conditions.version},     {"commit", conditions.commit},
            {"compiler", conditions.compiler},   {"renderer", conditions.renderer},
            {"command", conditions.command},     {"date", conditions.date},
            {"processor", conditions.processor}, {"processors", conditions.processors},
            {"load", conditions.load},           {"terrain", conditions.terrain},
            {"program", conditions.program},     {"terrain_identity", conditions.terrain_identity},
            {"flight", conditions.flight},       {"flight_identity", conditions.flight_identity},
            {"size", conditions.size},           {"device", conditions.device},
            {"design", conditions.design},       {"display_identity", conditions.display_identity},
            {"quick", conditions.is_quick}};
}

MeasuringConditions conditions_of(const Json& json) {
    MeasuringConditions conditions;
    conditions.version = json.at("version");
    conditions.commit = json.at("commit");
    conditions.compiler = json.at("compiler");
    conditions.renderer = json.at("renderer");
    conditions.command = json.at("command");
    conditions.date = json.at("date");
    conditions.processor = json.at("processor");
    conditions.processors = json.at("processors");
    conditions.load = json.at("load");
    conditions.terrain = json.at("terrain");
    conditions.program = json.at("program");
    conditions.terrain_identity = json.at("terrain_identity");
    conditions.flight = json.at("flight");
    conditions.flight_identity = json.at("flight_identity");
    conditions.size = json.at("size");
    conditions.device = json.at("device");
    conditions.design = json.at("design");
    conditions.display_identity = json.at("display_identity");
    conditions.is_quick = json.at("quick");
    return conditions;
}

AccuracyReport report_of(const Json& json) {
    AccuracyReport report;
    report.conditions = conditions_of(json.at("conditions"));
    report.interrupted = json.at("interrupted");
    for (const Json& knob : json.at("knobs")) report.knobs.push_back(knob_from(knob));
    if (!json.at("budget_ms").is_null()) report.budget_ms = json.at("budget_ms");
    for (const Json& name : json.at("not_measured")) report.not_measured.push_back(name);
    for (const Json& flight : json.at("flights")) report.flights.push_back(flight_from(flight));
    report.uncalled = uncalled_from(json.at("uncalled_effects"));
    report.governor = json.contains("governor") ? governor_choice_from(json.at("governor")) : std::nullopt;
    report.control = control_from(json.at("negative_control"));
    for (const Json& compared : json.at("comparisons")) report.comparisons.push_back(compared_from(compared));
    return report;
}

Json answer_json(const MeasuredKnob& knob, double budget_ms) {
    const std::optional<TimeAnswer> answer = answer_within(knob, budget_ms);
    const auto number = [&](double value) { return answer ? Json(value) : Json(nullptr); };
    const TimeAnswer known = answer.value_or(TimeAnswer());
    return {{"knob", knob.name},
            {"budget_ms", budget_ms},
            {"level", answer ? Json(known.level->name) : Json(nullptr)},
            {"spread_ms", number(known.need.spread_ms)},
            {"margin", number(known.need.margin)},
            {"needed_ms", number(known.need.needed_ms())},
            {"expected_share", number(known.expected_share)}};
}

/// To the budgets of the first screen, and of all knobs to the one that was asked for. They follow from the rest of the report,
/// so they are not read again.
Json answers_json(const AccuracyReport& report) {
    Json answers = Json::array();
    for (const MeasuredKnob& knob : report.knobs) {
        for (const FrameBudget& budget : kFrameBudgets)
            if (is_of_frames(knob)) answers.push_back(answer_json(knob, budget.ms));
        if (report.budget_ms) answers.push_back(answer_json(knob, *report.budget_ms));
    }
    return answers;
}

/// In quotation marks, which names of levels and units do without.
std::string csv_text(const std::string& text) { return "\"" + text + "\""; }

}  // namespace

Json accuracy_json(const AccuracyReport& report) {
    Json knobs = Json::array(), flights = Json::array(), comparisons = Json::array();
    for (const FlightErrors& flight : report.flights) flights.push_back(flight_json(flight));
    for (const MeasuredKnob& knob : report.knobs) knobs.push_back(knob_json(knob));
    for (const ComparedReport& compared : report.comparisons) comparisons.push_back(compared_json(compared));
    return {{"schema", kAccuracySchema},
            {"conditions", conditions_json(report.conditions)},
            {"interrupted", report.interrupted},
            {"knobs", std::move(knobs)},
            {"not_measured", report.not_measured},
            {"budget_ms", report.budget_ms ? Json(*report.budget_ms) : Json(nullptr)},
            {"answers", answers_json(report)},
            {"flights", std::move(flights)},
            {"uncalled_effects", uncalled_json(report.uncalled)},
            {"governor", governor_choice_json(report.governor)},
            {"negative_control", control_json(report.control)},
            {"comparisons", std::move(comparisons)}};
}

AccuracyReport read_accuracy(const std::string& text, const std::string& name) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object())
        throw UserError(name + ": is no JSON object; name an accuracy.json that tedavis accuracy wrote");
    const std::string schema = json.value("schema", "");
    if (schema != kAccuracySchema)
        throw UserError(name + ": has the schema '" + schema + "' and not '" + kAccuracySchema +
                        "'; measure it anew with this version of tedavis");
    try {
        return report_of(json);
    } catch (const Json::exception& fault) {
        throw UserError(name + ": is not whole (" + fault.what() + "); measure it anew");
    }
}

std::string accuracy_csv(const AccuracyReport& report) {
    std::string csv =
        "knob,level,amount,ms_median,ms_p5,ms_p95,unit,error_mean,error_p95,error_p99,error_max,bytes,build_ms,dominated,"
        "offered\n";
    char numbers[256];
    for (const MeasuredKnob& knob : report.knobs)
        for (const MeasuredLevel& level : knob.levels) {
            csv += knob.name + "," + csv_text(level.name);
            std::snprintf(numbers, sizeof numbers, ",%.9g,%.9g,%.9g,%.9g,", level.amount, level.ms.median, level.ms.p5,
                          level.ms.p95);
            csv += numbers + csv_text(knob.unit);
            std::snprintf(numbers, sizeof numbers, ",%.9g,%.9g,%.9g,%.9g,%llu,%.9g,%d,%d\n", level.error.mean, level.error.p95,
                          level.error.p99, level.error.max, static_cast<unsigned long long>(level.bytes), level.build_ms,
                          level.is_dominated ? 1 : 0, level.is_offered ? 1 : 0);
            csv += numbers;
        }
    return csv;
}

}  // namespace tedavis::host_sim
