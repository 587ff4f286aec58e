#include "host_sim/accuracy/accuracy_json.hpp"

#include <cstdio>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const ErrorDistribution& error) {
    return {{"mean", error.mean}, {"p95", error.p95}, {"p99", error.p99}, {"max", error.max}, {"count", error.count}};
}

ErrorDistribution error_of(const Json& json) {
    return {json.at("mean"), json.at("p95"), json.at("p99"), json.at("max"), json.at("count")};
}

Json level_json(const MeasuredLevel& level) {
    return {{"name", level.name},
            {"amount", level.amount},
            {"ms", {{"median", level.ms.median}, {"p5", level.ms.p5}, {"p95", level.ms.p95}}},
            {"error", error_json(level.error)},
            {"bytes", level.bytes},
            {"build_ms", level.build_ms},
            {"worst", level.worst_place},
            {"dominated", level.is_dominated},
            {"near_reference", level.is_near_reference},
            {"offered", level.is_offered}};
}

MeasuredLevel level_of(const Json& json) {
    MeasuredLevel level;
    level.name = json.at("name");
    level.amount = json.at("amount");
    const Json& ms = json.at("ms");
    level.ms = {ms.at("median"), ms.at("p5"), ms.at("p95")};
    level.error = error_of(json.at("error"));
    level.bytes = json.at("bytes");
    level.build_ms = json.at("build_ms");
    level.worst_place = json.at("worst");
    level.is_dominated = json.at("dominated");
    level.is_near_reference = json.at("near_reference");
    level.is_offered = json.at("offered");
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
            {"only_level", knob.only_level},
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
    knob.only_level = json.at("only_level");
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
    return {{"version", conditions.version},     {"commit", conditions.commit},
            {"compiler", conditions.compiler},   {"renderer", conditions.renderer},
            {"command", conditions.command},     {"date", conditions.date},
            {"processor", conditions.processor}, {"processors", conditions.processors},
            {"load", conditions.load},           {"terrain", conditions.terrain},
            {"program", conditions.program},     {"terrain_identity", conditions.terrain_identity},
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
    conditions.is_quick = json.at("quick");
    return conditions;
}

Json flight_json(const FlightErrors& flight) {
    Json moments = Json::array(), lines = Json::array();
    for (const MeasuredMoment& moment : flight.moments)
        moments.push_back({{"time_s", moment.time_s},
                           {"proven_px", moment.proven_px},
                           {"measured_px", moment.measured_px},
                           {"ms", moment.ms},
                           {"samples", moment.samples},
                           {"pose", moment.pose}});
    for (const ToleranceLine& line : flight.lines)
        lines.push_back({{"asked_px", line.asked_px},
                         {"proven_px", line.proven_px},
                         {"measured_px", line.measured_px},
                         {"samples", line.samples},
                         {"broken", line.broken}});
    return {{"flight", flight.flight},
            {"terrain", flight.terrain},
            {"asked_px", flight.asked_px},
            {"moments", std::move(moments)},
            {"lines", std::move(lines)}};
}

FlightErrors flight_of(const Json& json) {
    FlightErrors flight;
    flight.flight = json.at("flight");
    flight.terrain = json.at("terrain");
    flight.asked_px = json.at("asked_px");
    for (const Json& moment : json.at("moments"))
        flight.moments.push_back({moment.at("time_s"), moment.at("proven_px"), moment.at("measured_px"), moment.at("ms"),
                                  moment.at("samples"), moment.at("pose")});
    for (const Json& line : json.at("lines"))
        flight.lines.push_back(
            {line.at("asked_px"), line.at("proven_px"), line.at("measured_px"), line.at("samples"), line.at("broken")});
    return flight;
}

Json use_json(const EffectUse& use) {
    Json reasons = Json::array();
    for (const UncalledReason& reason : use.reasons) reasons.push_back({{"why", reason.text}, {"frames", reason.frames}});
    return {{"name", use.name},
            {"contribution", use.contribution},
            {"asked", use.asked},
            {"run", use.run},
            {"replaced", use.replaced},
            {"skipped", use.skipped},
            {"reasons", std::move(reasons)},
            {"skipped_work", use.skipped_work},
            {"bound", use.bound},
            {"saved_ms", use.saved.ms},
            {"saved_spread_ms", use.saved.spread_ms},
            {"largest_difference", use.largest_difference},
            {"worst_pose", use.worst_pose}};
}

EffectUse use_of(const Json& json) {
    EffectUse use;
    use.name = json.at("name");
    use.contribution = json.at("contribution");
    use.asked = json.at("asked");
    use.run = json.at("run");
    use.replaced = json.at("replaced");
    use.skipped = json.at("skipped");
    for (const Json& reason : json.at("reasons")) use.reasons.push_back({reason.at("why"), reason.at("frames")});
    use.skipped_work = json.at("skipped_work");
    use.bound = json.at("bound");
    use.saved = {json.at("saved_ms"), json.at("saved_spread_ms")};
    use.largest_difference = json.at("largest_difference");
    use.worst_pose = json.at("worst_pose");
    return use;
}

Json uncalled_json(const std::optional<UncalledEffects>& uncalled) {
    if (!uncalled) return nullptr;
    Json uses = Json::array();
    for (const EffectUse& use : uncalled->uses) uses.push_back(use_json(use));
    return {
        {"design", uncalled->design}, {"device", uncalled->device}, {"frames", uncalled->frames}, {"effects", std::move(uses)}};
}

std::optional<UncalledEffects> uncalled_of(const Json& json) {
    if (json.is_null()) return std::nullopt;
    UncalledEffects uncalled;
    uncalled.design = json.at("design");
    uncalled.device = json.at("device");
    uncalled.frames = json.at("frames");
    for (const Json& use : json.at("effects")) uncalled.uses.push_back(use_of(use));
    return uncalled;
}

Json control_json(const std::optional<NegativeControl>& control) {
    if (!control) return nullptr;
    return {{"title", control->title},
            {"unit", control->unit},
            {"wrong_name", control->wrong_name},
            {"right_name", control->right_name},
            {"worst", control->worst_place},
            {"reference_bound", control->reference_bound},
            {"wrong", error_json(control->wrong)},
            {"right", error_json(control->right)},
            {"caught", control->is_caught}};
}

std::optional<NegativeControl> control_of(const Json& json) {
    if (json.is_null()) return std::nullopt;
    NegativeControl control;
    control.title = json.at("title");
    control.unit = json.at("unit");
    control.wrong_name = json.at("wrong_name");
    control.right_name = json.at("right_name");
    control.worst_place = json.at("worst");
    control.reference_bound = json.at("reference_bound");
    control.wrong = error_of(json.at("wrong"));
    control.right = error_of(json.at("right"));
    control.is_caught = json.at("caught");
    return control;
}

Json compared_json(const ComparedReport& compared) {
    Json levels = Json::array();
    for (const ComparedLevel& level : compared.levels)
        levels.push_back({{"knob", level.knob},
                          {"level", level.level},
                          {"ms", level.ms},
                          {"earlier_ms", level.earlier_ms},
                          {"error", level.error},
                          {"earlier_error", level.earlier_error},
                          {"slower", level.is_slower},
                          {"less_accurate", level.is_less_accurate}});
    return {{"file", compared.file},       {"processor", compared.processor},          {"date", compared.date},
            {"version", compared.version}, {"same_machine", compared.is_same_machine}, {"levels", std::move(levels)},
            {"gone", compared.gone}};
}

ComparedReport compared_of(const Json& json) {
    ComparedReport compared;
    compared.file = json.at("file");
    compared.processor = json.at("processor");
    compared.date = json.at("date");
    compared.version = json.at("version");
    compared.is_same_machine = json.at("same_machine");
    for (const Json& level : json.at("levels"))
        compared.levels.push_back({level.at("knob"), level.at("level"), level.at("ms"), level.at("earlier_ms"), level.at("error"),
                                   level.at("earlier_error"), level.at("slower"), level.at("less_accurate")});
    for (const Json& name : json.at("gone")) compared.gone.push_back(name);
    return compared;
}

AccuracyReport report_of(const Json& json) {
    AccuracyReport report;
    report.conditions = conditions_of(json.at("conditions"));
    report.interrupted = json.at("interrupted");
    for (const Json& knob : json.at("knobs")) report.knobs.push_back(knob_of(knob));
    for (const Json& name : json.at("not_measured")) report.not_measured.push_back(name);
    for (const Json& flight : json.at("flights")) report.flights.push_back(flight_of(flight));
    report.uncalled = uncalled_of(json.at("uncalled_effects"));
    report.control = control_of(json.at("negative_control"));
    for (const Json& compared : json.at("comparisons")) report.comparisons.push_back(compared_of(compared));
    return report;
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
            {"flights", std::move(flights)},
            {"uncalled_effects", uncalled_json(report.uncalled)},
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
