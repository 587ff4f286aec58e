#include "host_sim/reports/calibration_file.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/json_text.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> names_of(const effects::EffectSet& effects) {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (effects.has(static_cast<effects::Effect>(n)))
            names.emplace_back(effects::row_of(static_cast<effects::Effect>(n)).name);
    return names;
}

Json candidate_json(const effects::QualityCandidate& candidate, const effects::QualityLevels& levels) {
    const effects::QualityLevel& level = candidate.level;
    Json chosen;
    for (std::size_t n = 0; n < levels.count; ++n) {
        const effects::QualityLevel& one = levels.at[n];
        const bool is_it = one.tau_factor == level.tau_factor && one.detail_factor == level.detail_factor &&
                           one.given_up.has_all(level.given_up) && level.given_up.has_all(one.given_up);
        if (is_it) chosen = n;
    }
    return {{"tau_factor", level.tau_factor},       {"detail_factor", level.detail_factor},
            {"given_up", names_of(level.given_up)}, {"ms", level.ms},
            {"spread_ms", candidate.spread_ms},     {"error_px", level.error_px},
            {"error_color", level.error_color},     {"level", chosen}};
}

}  // namespace

std::string calibration_json(const effects::MeasuredCosts& measured) {
    const effects::CalibrationSubject& of = measured.subject;
    Json json;
    json["device"] = std::string(of.device.view());
    json["renderer"] = std::string(of.renderer.view());
    json["size"] = std::to_string(of.width_px) + "x" + std::to_string(of.height_px);
    json["date"] = std::string(measured.date.view());
    json["design"] = std::string(measured.design.view());
    json["terrain"] = std::string(measured.terrain.view());
    json["rounds"] = measured.rounds;
    json["costs"] = Json::array();
    for (const effects::MeasuredCost& cost : measured.costs)
        json["costs"].push_back({{"name", std::string(cost.name.view())},
                                 {"ms", cost.ms},
                                 {"spread_ms", cost.spread_ms},
                                 {"fixed_ms", cost.line.fixed_ms},
                                 {"ms_per_megapixel", cost.line.ms_per_megapixel},
                                 {"ms_per_thousand", cost.line.ms_per_thousand},
                                 {"design", std::string(cost.design.view())},
                                 {"note", std::string(cost.note.view())}});
    const effects::QualityLevels levels = effects::choose_levels(measured.candidates);
    json["quality"] = Json::array();
    for (const effects::QualityCandidate& candidate : measured.candidates)
        json["quality"].push_back(candidate_json(candidate, levels));
    return json_text(json, 2) + "\n";
}

}  // namespace tedavis::host_sim
