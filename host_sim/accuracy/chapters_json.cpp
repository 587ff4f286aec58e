#include "host_sim/accuracy/chapters_json.hpp"

#include <utility>

#include "host_sim/accuracy/knob_json.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

Json use_json(const EffectUse& use) {
    Json json = effect_count_json(use);
    json["contribution"] = use.contribution;
    json["saved_ms"] = use.saved.ms;
    json["saved_spread_ms"] = use.saved.spread_ms;
    json["largest_difference"] = use.largest_difference;
    json["worst_pose"] = use.worst_pose;
    return json;
}

EffectUse use_of(const Json& json) {
    return {effect_count_from(json),
            json.at("contribution"),
            {json.at("saved_ms"), json.at("saved_spread_ms")},
            json.at("largest_difference"),
            json.at("worst_pose")};
}

Json quality_json(const effects::QualityLevel& level, std::uint64_t frames) {
    Json given_up = Json::array();
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (level.given_up.has(static_cast<effects::Effect>(n)))
            given_up.push_back(effects::row_of(static_cast<effects::Effect>(n)).name);
    return {{"tau_factor", level.tau_factor},
            {"detail_factor", level.detail_factor},
            {"given_up", std::move(given_up)},
            {"ms", level.ms},
            {"error_px", level.error_px},
            {"error_color", level.error_color},
            {"frames", frames}};
}

effects::QualityLevel quality_of(const Json& json) {
    effects::QualityLevel level{json.at("tau_factor"), json.at("detail_factor"), {},
                                json.at("ms"),         json.at("error_px"),      json.at("error_color")};
    for (const Json& name : json.at("given_up")) {
        const effects::Effect effect = effects::effect_of(name.get<std::string>());
        if (effect != effects::Effect::count_) level.given_up.add(effect);
    }
    return level;
}

Json ranks_json(const RankAgreement& ranks) {
    const std::optional<double> tau = ranks.tau();
    return {{"common", ranks.common},     {"pairs", ranks.pairs},   {"alike", ranks.alike},
            {"distinct", ranks.distinct}, {"ranked", ranks.ranked}, {"kendall_tau", tau ? Json(*tau) : Json()}};
}

}  // namespace

nlohmann::ordered_json flight_json(const FlightErrors& flight) {
    Json moments = Json::array(), lines = Json::array();
    for (const MeasuredMoment& moment : flight.moments)
        moments.push_back({{"time_s", moment.time_s},
                           {"proven_px", moment.proven_px},
                           {"measured_px", moment.measured_px},
                           {"ms", moment.ms},
                           {"samples", moment.samples},
                           {"pose", moment.pose},
                           {"phase", moment.phase}});
    for (const ToleranceLine& line : flight.lines)
        lines.push_back({{"asked_px", line.asked_px},
                         {"proven_px", line.proven_px},
                         {"measured_px", line.measured_px},
                         {"samples", line.samples},
                         {"broken", line.broken},
                         {"tightness", {{"median", line.tightness.median}, {"max", line.tightness.max}}}});
    return {{"flight", flight.flight},
            {"terrain", flight.terrain},
            {"identity", flight.identity},
            {"terrain_identity", flight.terrain_identity},
            {"drawn", flight.drawn},
            {"asked_px", flight.asked_px},
            {"known_to_px", flight.known_to_px},
            {"moments", std::move(moments)},
            {"lines", std::move(lines)}};
}

FlightErrors flight_from(const nlohmann::ordered_json& json) {
    FlightErrors flight;
    flight.flight = json.at("flight");
    flight.terrain = json.at("terrain");
    flight.identity = json.at("identity");
    flight.terrain_identity = json.at("terrain_identity");
    flight.drawn = json.at("drawn");
    flight.asked_px = json.at("asked_px");
    flight.known_to_px = json.at("known_to_px");
    for (const Json& moment : json.at("moments"))
        flight.moments.push_back({moment.at("time_s"), moment.at("proven_px"), moment.at("measured_px"), moment.at("ms"),
                                  moment.at("samples"), moment.at("pose"), moment.at("phase")});
    for (const Json& line : json.at("lines"))
        flight.lines.push_back({line.at("asked_px"),
                                line.at("proven_px"),
                                line.at("measured_px"),
                                line.at("samples"),
                                line.at("broken"),
                                {line.at("tightness").at("median"), line.at("tightness").at("max")}});
    return flight;
}

nlohmann::ordered_json uncalled_json(const std::optional<UncalledEffects>& uncalled) {
    if (!uncalled) return nullptr;
    Json uses = Json::array();
    for (const EffectUse& use : uncalled->uses) uses.push_back(use_json(use));
    return {
        {"design", uncalled->design}, {"device", uncalled->device}, {"frames", uncalled->frames}, {"effects", std::move(uses)}};
}

std::optional<UncalledEffects> uncalled_from(const nlohmann::ordered_json& json) {
    if (json.is_null()) return std::nullopt;
    UncalledEffects uncalled;
    uncalled.design = json.at("design");
    uncalled.device = json.at("device");
    uncalled.frames = json.at("frames");
    for (const Json& use : json.at("effects")) uncalled.uses.push_back(use_of(use));
    return uncalled;
}

nlohmann::ordered_json governor_choice_json(const std::optional<GovernorChoice>& choice) {
    if (!choice) return nullptr;
    Json levels = Json::array();
    for (std::size_t n = 0; n < choice->levels.count; ++n)
        levels.push_back(quality_json(choice->levels.at[n], choice->frames[n]));
    return {{"costs", choice->costs},     {"device", choice->device},           {"renderer", choice->renderer},
            {"flight", choice->flight},   {"deadline_ms", choice->deadline_ms}, {"missed", choice->missed},
            {"levels", std::move(levels)}};
}

std::optional<GovernorChoice> governor_choice_from(const nlohmann::ordered_json& json) {
    if (json.is_null()) return std::nullopt;
    GovernorChoice choice;
    choice.costs = json.at("costs");
    choice.device = json.at("device");
    choice.renderer = json.at("renderer");
    choice.flight = json.at("flight");
    choice.deadline_ms = json.at("deadline_ms");
    choice.missed = json.at("missed");
    choice.levels.count = 0;
    for (const Json& level : json.at("levels")) {
        if (choice.levels.count == effects::kQualityLevelCount) break;
        choice.levels.at[choice.levels.count] = quality_of(level);
        choice.frames[choice.levels.count++] = level.at("frames");
    }
    return choice;
}

nlohmann::ordered_json control_json(const std::optional<NegativeControl>& control) {
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

std::optional<NegativeControl> control_from(const nlohmann::ordered_json& json) {
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

nlohmann::ordered_json compared_json(const ComparedReport& compared) {
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
            {"gone", compared.gone},       {"ranks", ranks_json(compared.ranks)}};
}

ComparedReport compared_from(const nlohmann::ordered_json& json) {
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
    const Json& ranks = json.at("ranks");
    compared.ranks = {ranks.at("common"), ranks.at("pairs"), ranks.at("alike"), ranks.at("distinct"), ranks.at("ranked")};
    return compared;
}

}  // namespace tedavis::host_sim
