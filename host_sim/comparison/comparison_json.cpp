#include "host_sim/comparison/comparison_json.hpp"

#include <cmath>

#include "host_sim/comparison/comparison_words.hpp"
#include "host_sim/comparison/height_words.hpp"

namespace tedavis::host_sim {
namespace {

using ComparisonJson = nlohmann::ordered_json;

ComparisonJson known_or_null(double value) { return std::isfinite(value) ? ComparisonJson(value) : ComparisonJson(); }

ComparisonJson names_json(const ComparedRun& run) {
    return {{"folder", run.folder},     {"log", run.log},         {"design", run.design},   {"device", run.device},
            {"aircraft", run.aircraft}, {"palette", run.palette}, {"light", run.light},     {"terrain", run.terrain},
            {"scene", run.scene},       {"size", run.size},       {"version", run.version}, {"frames", run.frames.size()}};
}

ComparisonJson quantity_json(const QuantityDifference& one) {
    const Quantity& quantity = kQuantities[one.quantity];
    return {{"quantity", quantity.name},
            {"unit", quantity.unit},
            {"instants", one.count},
            {"values_a", one.values_a},
            {"values_b", one.values_b},
            {"mean_a", one.mean_a},
            {"mean_b", one.mean_b},
            {"median_a", one.median_a},
            {"median_b", one.median_b},
            {"least_a", {{"value", known_or_null(one.least_a)}, {"instant", one.least_a_at}}},
            {"least_b", {{"value", known_or_null(one.least_b)}, {"instant", one.least_b_at}}},
            {"greatest", {{"value", one.greatest}, {"instant", one.greatest_at}}}};
}

ComparisonJson levels_json(const AlertLevels& levels) {
    return {{"none", levels[0]}, {"caution", levels[1]}, {"warning", levels[2]}};
}

ComparisonJson heights_json(const ComparedRun& run) {
    return {{"are_assumed", run.assumes_heights},
            {"pressure_frames", frames_by_pressure(run)},
            {"ground_known_frames", frames_over_known_ground(run)},
            {"frames", run.frames.size()}};
}

ComparisonJson closest_json_of(const std::optional<RunClosest>& closest) {
    if (!closest) return {};
    return {{"height_above_terrain_m", closest->height_m},
            {"time_s", closest->time_s},
            {"lat_deg", known_or_null(closest->latitude_deg)},
            {"lon_deg", known_or_null(closest->longitude_deg)},
            {"phase", closest->phase},
            {"searched", closest->is_of_summary ? "run" : "frames"},
            {"left_out_s", closest->is_of_summary ? ComparisonJson(closest->left_out_s) : ComparisonJson()},
            {"unknown_s", closest->is_of_summary ? ComparisonJson(closest->unknown_s) : ComparisonJson()}};
}

template <class Value>
ComparisonJson frame_json(const ComparedFrame& frame, Value value_of) {
    static constexpr const char* kLevelNames[] = {"none", "caution", "warning"};
    ComparisonJson json{{"frame", frame.frame},
                        {"time_s", frame.time_s},
                        {"utc_s", frame.utc_s ? ComparisonJson(*frame.utc_s) : ComparisonJson()},
                        {"hash", knows_picture(frame) ? ComparisonJson(frame.hash) : ComparisonJson()},
                        {"phase", frame.phase},
                        {"lat_deg", frame.has_place ? ComparisonJson(frame.latitude_deg) : ComparisonJson()},
                        {"lon_deg", frame.has_place ? ComparisonJson(frame.longitude_deg) : ComparisonJson()},
                        {"terrain_alert", kLevelNames[frame.terrain_alert]},
                        {"obstacle_alert", kLevelNames[frame.obstacle_alert]},
                        {"effects", frame.effects}};
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        json[kQuantities[quantity].name] = known_or_null(value_of(quantity));
    return json;
}

ComparisonJson instant_json(const RunComparison& runs, std::size_t n) {
    const AlignedInstant& instant = runs.aligned.instants[n];
    return {{"axis", instant.axis},
            {"position_in_b", instant.b},
            {"distance_m", known_or_null(instant.distance_m)},
            {"a", frame_json(runs.frame_a(n), [&](std::size_t quantity) { return runs.value_a(n, quantity); })},
            {"b", frame_json(runs.frame_b(n), [&](std::size_t quantity) { return runs.value_b(n, quantity); })}};
}

}  // namespace

nlohmann::ordered_json comparison_json(const RunComparison& runs) {
    ComparisonJson json{{"comparison", comparison_title(runs)},
                        {"sentences", difference_sentences(runs)},
                        {"warnings", comparison_warnings(runs)},
                        {"equal", runs.is_equal()},
                        {"a", names_json(runs.a)},
                        {"b", names_json(runs.b)},
                        {"alignment",
                         {{"by", name_of(runs.aligned.by)},
                          {"words", runs.aligned.words},
                          {"axis", runs.aligned.axis},
                          {"unit", runs.aligned.axis_unit},
                          {"stride_a", runs.aligned.stride_a},
                          {"stride_b", runs.aligned.stride_b},
                          {"searched", runs.aligned.searched},
                          {"without_counterpart", runs.aligned.searched - runs.aligned.instants.size()}}}};
    json["compared_frames"] = {{"a", runs.compared_a.size()}, {"b", runs.compared_b.size()}};
    json["heights"] = {{"a", heights_json(runs.a)}, {"b", heights_json(runs.b)}};
    json["closest"] = {{"a", closest_json_of(runs.closest_a)}, {"b", closest_json_of(runs.closest_b)}};
    json["differences"] = ComparisonJson::array();
    for (const QuantityDifference& one : runs.quantities) json["differences"].push_back(quantity_json(one));
    json["known_by_one"] = ComparisonJson::object();
    for (std::size_t quantity = 0; quantity < kQuantityCount; ++quantity)
        json["known_by_one"][kQuantities[quantity].name] = runs.known_by_one[quantity];
    json["effects"] = ComparisonJson::array();
    for (const EffectDifference& one : runs.effects)
        json["effects"].push_back({{"name", one.name}, {"frames_a", one.frames_a}, {"frames_b", one.frames_b}});
    json["alerts"] = {{"terrain", {{"a", levels_json(runs.terrain_a)}, {"b", levels_json(runs.terrain_b)}}},
                      {"obstacles", {{"a", levels_json(runs.obstacles_a)}, {"b", levels_json(runs.obstacles_b)}}}};
    json["other_phase"] = runs.other_phase;
    json["known_pictures"] = runs.known_pictures;
    json["equal_pictures"] = runs.equal_pictures;
    json["instants"] = ComparisonJson::array();
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) json["instants"].push_back(instant_json(runs, n));
    return json;
}

}  // namespace tedavis::host_sim
