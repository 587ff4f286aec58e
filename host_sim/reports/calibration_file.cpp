#include "host_sim/reports/calibration_file.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/json_text.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

/// A TOML basic string of what a driver or a file calls itself.
std::string toml_text(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) continue;
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

/// Of one line, so that it can stand behind a '#'.
std::string comment(std::string_view text) {
    std::string out = "# ";
    for (const char c : text) out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    return out + '\n';
}

std::string number(const char* key, double value) {
    char line[80];
    std::snprintf(line, sizeof line, "%s = %.6f\n", key, value);
    return line;
}

std::string cost_toml(const MeasuredCost& cost) {
    std::string text = "\n";
    if (!cost.note.empty()) text += comment("not measured: " + cost.note);
    text += "[cost." + cost.name + "]\n";
    text += number("fixed_ms", cost.line.fixed_ms);
    text += number("ms_per_megapixel", cost.line.ms_per_megapixel);
    return text + number("ms_per_thousand", cost.line.ms_per_thousand);
}

std::vector<std::string> names_of(const effects::EffectSet& effects) {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        if (effects.has(static_cast<effects::Effect>(n)))
            names.emplace_back(effects::row_of(static_cast<effects::Effect>(n)).name);
    return names;
}

std::string level_toml(const effects::QualityLevel& level) {
    std::string text = "\n[[quality]]\n" + number("tau_factor", level.tau_factor) + number("detail_factor", level.detail_factor);
    text += "given_up = [";
    for (const std::string& name : names_of(level.given_up)) text += (text.back() == '[' ? "" : ", ") + toml_text(name);
    text += "]\n" + number("ms", level.ms) + number("error_px", level.error_px);
    return text + number("error_color", level.error_color);
}

Json candidate_json(const QualityCandidate& candidate, const effects::QualityLevels& levels) {
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

std::string calibration_toml(const MeasuredCosts& measured) {
    const effects::CalibrationSubject& of = measured.subject;
    std::string text = comment("What everything costs on one display, by tedavis calibrate, over " + measured.terrain +
                               " with the design " + measured.design + ".");
    text += "device = " + toml_text(of.device.view()) + "\nrenderer = " + toml_text(of.renderer.view()) +
            "\nwidth_px = " + std::to_string(of.width_px) + "\nheight_px = " + std::to_string(of.height_px) +
            "\ndate = " + toml_text(measured.date) + "\n";
    for (const MeasuredCost& cost : measured.costs) text += cost_toml(cost);
    text += "\n" + comment("The quality levels that the governor may choose, from the design's own picture to the cheapest one.");
    const effects::QualityLevels levels = choose_levels(measured.candidates);
    for (std::size_t n = 0; n < levels.count; ++n) text += level_toml(levels.at[n]);
    return text;
}

std::string calibration_json(const MeasuredCosts& measured) {
    const effects::CalibrationSubject& of = measured.subject;
    Json json;
    json["device"] = std::string(of.device.view());
    json["renderer"] = std::string(of.renderer.view());
    json["size"] = std::to_string(of.width_px) + "x" + std::to_string(of.height_px);
    json["date"] = measured.date;
    json["design"] = measured.design;
    json["terrain"] = measured.terrain;
    json["rounds"] = measured.rounds;
    json["costs"] = Json::array();
    for (const MeasuredCost& cost : measured.costs)
        json["costs"].push_back({{"name", cost.name},
                                 {"ms", cost.ms},
                                 {"spread_ms", cost.spread_ms},
                                 {"fixed_ms", cost.line.fixed_ms},
                                 {"ms_per_megapixel", cost.line.ms_per_megapixel},
                                 {"ms_per_thousand", cost.line.ms_per_thousand},
                                 {"design", cost.design},
                                 {"note", cost.note}});
    const effects::QualityLevels levels = choose_levels(measured.candidates);
    json["quality"] = Json::array();
    for (const QualityCandidate& candidate : measured.candidates) json["quality"].push_back(candidate_json(candidate, levels));
    return json_text(json, 2) + "\n";
}

}  // namespace tedavis::host_sim
