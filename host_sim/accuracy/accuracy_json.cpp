#include "host_sim/accuracy/accuracy_json.hpp"

#include <cstdio>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json level_json(const MeasuredLevel& level) {
    return {{"name", level.name},
            {"amount", level.amount},
            {"ms", {{"median", level.ms.median}, {"p5", level.ms.p5}, {"p95", level.ms.p95}}},
            {"error",
             {{"mean", level.error.mean},
              {"p95", level.error.p95},
              {"p99", level.error.p99},
              {"max", level.error.max},
              {"count", level.error.count}}},
            {"bytes", level.bytes},
            {"build_ms", level.build_ms},
            {"worst", level.worst_place},
            {"dominated", level.is_dominated},
            {"near_reference", level.is_near_reference}};
}

MeasuredLevel level_of(const Json& json) {
    MeasuredLevel level;
    level.name = json.at("name");
    level.amount = json.at("amount");
    const Json &ms = json.at("ms"), &error = json.at("error");
    level.ms = {ms.at("median"), ms.at("p5"), ms.at("p95")};
    level.error = {error.at("mean"), error.at("p95"), error.at("p99"), error.at("max"), error.at("count")};
    level.bytes = json.at("bytes");
    level.build_ms = json.at("build_ms");
    level.worst_place = json.at("worst");
    level.is_dominated = json.at("dominated");
    level.is_near_reference = json.at("near_reference");
    return level;
}

Json law_json(const FittedLaw& law) {
    return {{"holds", law.holds},
            {"exponent", law.exponent},
            {"factor", law.factor},
            {"r2", law.r2},
            {"worst_residual", law.worst_residual},
            {"reason", law.reason}};
}

FittedLaw law_of(const Json& json) {
    return {json.at("holds"), json.at("exponent"),       json.at("factor"),
            json.at("r2"),    json.at("worst_residual"), json.at("reason")};
}

Json work_json(const MeasuredWork& work) {
    return {{"thing", work.thing},
            {"counts", work.counts},
            {"law", law_json(work.law)},
            {"law_expected", work.law_expected},
            {"law_agrees", work.law_agrees},
            {"fixed_ms", work.fixed_ms},
            {"ms_per_thousand", work.ms_per_thousand}};
}

MeasuredWork work_of(const Json& json) {
    MeasuredWork work;
    work.thing = json.at("thing");
    work.counts = json.at("counts").get<std::vector<double>>();
    work.law = law_of(json.at("law"));
    work.law_expected = json.at("law_expected");
    work.law_agrees = json.at("law_agrees");
    work.fixed_ms = json.at("fixed_ms");
    work.ms_per_thousand = json.at("ms_per_thousand");
    return work;
}

Json knob_json(const MeasuredKnob& knob) {
    Json levels = Json::array();
    for (const MeasuredLevel& level : knob.levels) levels.push_back(level_json(level));
    return {{"name", knob.name},
            {"title", knob.title},
            {"setting", knob.setting},
            {"metric", knob.metric},
            {"unit", knob.unit},
            {"amount", knob.amount},
            {"reference", {{"what", knob.reference}, {"bound", knob.reference_bound}, {"reason", knob.reference_reason}}},
            {"second_oracle", knob.second_oracle},
            {"never_trades", knob.never_trades},
            {"rounds", knob.rounds},
            {"samples", knob.samples},
            {"noise", knob.noise},
            {"error_law", law_json(knob.error_law)},
            {"time_law", law_json(knob.time_law)},
            {"law_expected", knob.law_expected},
            {"law_agrees", knob.law_agrees},
            {"work", knob.work ? work_json(*knob.work) : Json()},
            {"levels", std::move(levels)}};
}

MeasuredKnob knob_of(const Json& json) {
    MeasuredKnob knob;
    knob.name = json.at("name");
    knob.title = json.at("title");
    knob.setting = json.at("setting");
    knob.metric = json.at("metric");
    knob.unit = json.at("unit");
    knob.amount = json.at("amount");
    const Json& reference = json.at("reference");
    knob.reference = reference.at("what");
    knob.reference_bound = reference.at("bound");
    knob.reference_reason = reference.at("reason");
    knob.second_oracle = json.at("second_oracle");
    knob.never_trades = json.at("never_trades");
    knob.rounds = json.at("rounds");
    knob.samples = json.at("samples");
    knob.noise = json.at("noise");
    knob.error_law = law_of(json.at("error_law"));
    knob.time_law = law_of(json.at("time_law"));
    knob.law_expected = json.at("law_expected");
    knob.law_agrees = json.at("law_agrees");
    if (!json.at("work").is_null()) knob.work = work_of(json.at("work"));
    for (const Json& level : json.at("levels")) knob.levels.push_back(level_of(level));
    return knob;
}

Json conditions_json(const MeasuringConditions& conditions) {
    return {{"version", conditions.version},     {"compiler", conditions.compiler},
            {"command", conditions.command},     {"date", conditions.date},
            {"processor", conditions.processor}, {"processors", conditions.processors},
            {"load", conditions.load},           {"terrain", conditions.terrain},
            {"program", conditions.program},     {"terrain_identity", conditions.terrain_identity},
            {"quick", conditions.is_quick}};
}

MeasuringConditions conditions_of(const Json& json) {
    MeasuringConditions conditions;
    conditions.version = json.at("version");
    conditions.compiler = json.at("compiler");
    conditions.command = json.at("command");
    conditions.date = json.at("date");
    conditions.processor = json.at("processor");
    conditions.processors = json.at("processors");
    conditions.load = json.at("load");
    conditions.terrain = json.at("terrain");
    conditions.program = json.at("program");
    conditions.terrain_identity = json.at("terrain_identity");
    conditions.is_quick = json.at("quick");
    return conditions;
}

AccuracyReport report_of(const Json& json) {
    AccuracyReport report;
    report.conditions = conditions_of(json.at("conditions"));
    report.interrupted = json.at("interrupted");
    for (const Json& knob : json.at("knobs")) report.knobs.push_back(knob_of(knob));
    for (const Json& name : json.at("not_measured")) report.not_measured.push_back(name);
    return report;
}

/// In quotation marks, which names of levels and units do without.
std::string csv_text(const std::string& text) { return "\"" + text + "\""; }

}  // namespace

Json accuracy_json(const AccuracyReport& report) {
    Json knobs = Json::array();
    for (const MeasuredKnob& knob : report.knobs) knobs.push_back(knob_json(knob));
    return {{"schema", kAccuracySchema},
            {"conditions", conditions_json(report.conditions)},
            {"interrupted", report.interrupted},
            {"knobs", std::move(knobs)},
            {"not_measured", report.not_measured}};
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
        "knob,level,amount,ms_median,ms_p5,ms_p95,unit,error_mean,error_p95,error_p99,error_max,bytes,build_ms,dominated\n";
    char numbers[256];
    for (const MeasuredKnob& knob : report.knobs)
        for (const MeasuredLevel& level : knob.levels) {
            csv += knob.name + "," + csv_text(level.name);
            std::snprintf(numbers, sizeof numbers, ",%.9g,%.9g,%.9g,%.9g,", level.amount, level.ms.median, level.ms.p5,
                          level.ms.p95);
            csv += numbers + csv_text(knob.unit);
            std::snprintf(numbers, sizeof numbers, ",%.9g,%.9g,%.9g,%.9g,%llu,%.9g,%d\n", level.error.mean, level.error.p95,
                          level.error.p99, level.error.max, static_cast<unsigned long long>(level.bytes), level.build_ms,
                          level.is_dominated ? 1 : 0);
            csv += numbers;
        }
    return csv;
}

}  // namespace tedavis::host_sim
