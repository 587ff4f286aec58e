#include "host_sim/accuracy/knob_json.hpp"

#include <utility>

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json pixel_json(const std::optional<KnobPixel>& pixel) {
    if (!pixel) return nullptr;
    return {pixel->x, pixel->y};
}

std::optional<KnobPixel> pixel_from(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return KnobPixel{json.at(0), json.at(1)};
}

Json spread_json(const TimeSpread& spread) { return {{"median", spread.median}, {"p5", spread.p5}, {"p95", spread.p95}}; }
TimeSpread spread_from(const Json& json) { return {json.at("median"), json.at("p5"), json.at("p95")}; }

Json level_json(const MeasuredLevel& level) {
    return {{"name", level.name},
            {"amount", level.amount},
            {"options", level.options},
            {"ms", spread_json(level.ms)},
            {"sample_ms", spread_json(level.sample_ms)},
            {"kept_ms", level.kept_ms},
            {"kept_99_ms", level.kept_99_ms},
            {"error", error_json(level.error)},
            {"bytes", level.bytes},
            {"proven", level.proven ? Json(*level.proven) : Json(nullptr)},
            {"uploaded_bytes", level.uploaded_bytes ? Json(*level.uploaded_bytes) : Json(nullptr)},
            {"build_ms", level.build_ms},
            {"worst",
             {{"place", level.worst_place},
              {"command", level.worst_command},
              {"sample", level.worst_sample},
              {"pixel", pixel_json(level.worst_pixel)}}},
            {"dominated", level.is_dominated},
            {"near_reference", level.is_near_reference},
            {"offered", level.is_offered}};
}

MeasuredLevel level_of(const Json& json) {
    MeasuredLevel level;
    level.name = json.at("name");
    level.amount = json.at("amount");
    level.options = json.at("options");
    level.ms = spread_from(json.at("ms"));
    level.sample_ms = spread_from(json.at("sample_ms"));
    level.kept_ms = json.at("kept_ms");
    level.kept_99_ms = json.at("kept_99_ms");
    level.error = error_of(json.at("error"));
    level.bytes = json.at("bytes");
    if (!json.at("proven").is_null()) level.proven = json.at("proven");
    if (!json.at("uploaded_bytes").is_null()) level.uploaded_bytes = json.at("uploaded_bytes");
    level.build_ms = json.at("build_ms");
    const Json& worst = json.at("worst");
    level.worst_place = worst.at("place");
    level.worst_command = worst.at("command");
    level.worst_sample = worst.at("sample");
    level.worst_pixel = pixel_from(worst.at("pixel"));
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

Json pictures_json(const std::optional<KnobPictures>& pictures) {
    if (!pictures) return nullptr;
    Json files;
    for (const auto& [what, picture] : named_pictures(*pictures)) files[what] = picture->file;
    const PictureErrors& errors = pictures->errors;
    return {{"cheap_level", pictures->cheap_level},
            {"exact_level", pictures->exact_level},
            {"place", pictures->place.pose},
            {"command", pictures->place.command},
            {"pixel", {pictures->place.x, pictures->place.y}},
            {"ciede2000", {{"mean", errors.color_mean}, {"max", errors.color_max}}},
            {"flip", {{"mean", errors.perceived_mean}, {"max", errors.perceived_max}}},
            {"metric", pictures->metric},
            {"metric_max", pictures->metric_max},
            {"files", std::move(files)}};
}

std::optional<KnobPictures> pictures_from(const std::string& knob, const Json& json) {
    if (json.is_null()) return std::nullopt;
    KnobPictures pictures;
    pictures.knob = knob;
    pictures.cheap_level = json.at("cheap_level");
    pictures.exact_level = json.at("exact_level");
    pictures.place = {json.at("place"), json.at("command"), json.at("pixel").at(0), json.at("pixel").at(1)};
    const Json &color = json.at("ciede2000"), &perceived = json.at("flip");
    pictures.errors = {color.at("mean"), color.at("max"), perceived.at("mean"), perceived.at("max")};
    pictures.metric = json.at("metric");
    pictures.metric_max = json.at("metric_max");
    for (const auto& [what, picture] : named_pictures(pictures)) picture->file = json.at("files").at(what);
    return pictures;
}

}  // namespace

nlohmann::ordered_json error_json(const ErrorDistribution& error) {
    return {{"mean", error.mean}, {"p95", error.p95}, {"p99", error.p99}, {"max", error.max}, {"count", error.count}};
}

ErrorDistribution error_of(const nlohmann::ordered_json& json) {
    return {json.at("mean"), json.at("p95"), json.at("p99"), json.at("max"), json.at("count")};
}

nlohmann::ordered_json knob_json(const MeasuredKnob& knob) {
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
            {"moments", knob.moments},
            {"dearest", knob.dearest},
            {"error_law", law_json(knob.error_law)},
            {"time_law", law_json(knob.time_law)},
            {"law_expected", knob.law_expected},
            {"law_agrees", knob.law_agrees},
            {"work", knob.work ? work_json(*knob.work) : Json()},
            {"levels", std::move(levels)},
            {"pictures", pictures_json(knob.pictures)}};
}

MeasuredKnob knob_from(const nlohmann::ordered_json& json) {
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
    knob.moments = json.at("moments");
    knob.dearest = json.at("dearest");
    knob.error_law = law_of(json.at("error_law"));
    knob.time_law = law_of(json.at("time_law"));
    knob.law_expected = json.at("law_expected");
    knob.law_agrees = json.at("law_agrees");
    if (!json.at("work").is_null()) knob.work = work_of(json.at("work"));
    for (const Json& level : json.at("levels")) knob.levels.push_back(level_of(level));
    knob.pictures = pictures_from(knob.name, json.at("pictures"));
    return knob;
}

}  // namespace tedavis::host_sim
