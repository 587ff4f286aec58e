#include "host_sim/evaluation/plan_lines.hpp"

#include <cmath>

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

/// Null where a step of the way is missing.
const Json& entry(const Json& json, std::initializer_list<const char*> keys) {
    static const Json none;
    const Json* at = &json;
    for (const char* key : keys) {
        if (!at->is_object() || !at->contains(key)) return none;
        at = &(*at)[key];
    }
    return *at;
}

std::string text_at(const Json& json, std::initializer_list<const char*> keys) {
    const Json& found = entry(json, keys);
    return found.is_string() ? found.get<std::string>() : std::string();
}

std::string number_at(const Json& json, std::initializer_list<const char*> keys, int digits) {
    const Json& found = entry(json, keys);
    if (!found.is_number()) return {};
    std::string text = decimal(found.get<double>(), digits);
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

void append(std::string& list, const std::string& word) {
    if (!word.empty()) list += (list.empty() ? "" : ", ") + word;
}

std::string spaced(std::string name) {
    for (char& c : name) c = c == '_' ? ' ' : c;
    return name;
}

std::string weights(const Json& record) {
    std::string text;
    for (const char* aspect : {"terrain", "data", "uncertainty"}) {
        const std::string weight = number_at(record, {"presentation", aspect, "weight"}, 2);
        if (!weight.empty()) append(text, std::string(aspect) + " " + weight);
    }
    return text;
}

std::string terrain(const Json& record) {
    std::string text = spaced(text_at(record, {"presentation", "terrain", "technique"}));
    const std::string triangles = number_at(record, {"terrain", "triangles"}, 0);
    if (!triangles.empty()) append(text, triangles + " triangles");
    const std::string detail = number_at(record, {"presentation", "terrain", "detail"}, 2);
    if (!detail.empty()) append(text, "detail " + detail);
    return text;
}

/// "wind 68 of 400, obstacle 8"
std::string data(const Json& record) {
    std::string text;
    const Json& types = entry(record, {"data"});
    if (!types.is_object()) return text;
    for (const auto& type : types.items()) {
        const auto count = [&](const char* key) {
            const Json& found = entry(type.value(), {key});
            return found.is_number() ? found.get<long long>() : 0LL;
        };
        const long long drawn = count("drawn"), left_out = count("hidden") + count("aggregated");
        if (drawn + left_out == 0) continue;
        append(text, spaced(type.key()) + " " + std::to_string(drawn) +
                         (left_out > 0 ? " of " + std::to_string(drawn + left_out) : std::string()));
    }
    return text;
}

std::string labels(const Json& record) {
    const std::string placed = number_at(record, {"labels", "placed"}, 0);
    return placed.empty() ? placed : placed + " placed, " + number_at(record, {"labels", "suppressed"}, 0) + " suppressed";
}

/// "wind, place in 5 regions; 2 signs"
std::string decluttered_roles(const Json& record) {
    std::string text;
    for (const Json& role : entry(record, {"clutter", "decluttered_roles"})) append(text, spaced(role.get<std::string>()));
    if (text.empty()) return text;
    std::size_t regions = 0;
    for (const Json& region : entry(record, {"clutter", "regions"})) regions += region.value("detail", 1.0) < 1 ? 1 : 0;
    text += " in " + std::to_string(regions) + (regions == 1 ? " region" : " regions");
    const std::string signs = number_at(record, {"labels", "decluttered"}, 0);
    return signs.empty() || signs == "0" ? text : text + "; " + signs + " signs";
}

std::string effects(const Json& record, const std::string& state) {
    std::string text, last;
    const Json& all = entry(record, {"effects"});
    if (!all.is_array()) return text;
    for (const Json& effect : all) {
        std::string name = text_at(effect, {"name"});
        if (text_at(effect, {"state"}) != state || name.rfind("data.", 0) == 0 || name == last) continue;
        last = name;
        if (state == "replaced") name += " by " + text_at(effect, {"replaced_by"});
        append(text, spaced(name));
    }
    return text;
}

std::string foci(const Json& record) {
    std::string text;
    const Json& all = entry(record, {"foci"});
    if (!all.is_array()) return text;
    for (const Json& focus : all)
        if (entry(focus, {"shown"}) == Json(true)) append(text, text_at(focus, {"name"}));
    return text;
}

std::string flags(const Json& record) {
    std::string text;
    const Json& all = entry(record, {"flags"});
    if (!all.is_array()) return text;
    for (const Json& flag : all)
        if (flag.is_string()) append(text, flag.get<std::string>());
    return text;
}

std::string own_ship(const Json& record) {
    std::string text = text_at(record, {"own_ship", "state"});
    const std::string altitude = number_at(record, {"own_ship", "alt_msl_m"}, 0);
    if (altitude.empty()) return text;
    text = altitude + " m MSL, heading " + number_at(record, {"own_ship", "heading_deg"}, 0) + "°, pitch " +
           number_at(record, {"own_ship", "pitch_deg"}, 0) + "°, roll " + number_at(record, {"own_ship", "roll_deg"}, 0) + "°";
    return text;
}

}  // namespace

PlanLines plan_lines(const Json& record) {
    PlanLines lines;
    const auto add = [&](const char* term, const std::string& words) {
        if (!words.empty()) lines.emplace_back(term, words);
    };
    add("design", text_at(record, {"presentation", "design"}));
    add("weights", weights(record));
    add("terrain", terrain(record));
    add("data drawn", data(record));
    add("labels", labels(record));
    add("gives way", decluttered_roles(record));
    add("foci", foci(record));
    add("effects run", effects(record, "run"));
    add("replaced", effects(record, "replaced"));
    add("flags", flags(record));
    add("own ship", own_ship(record));
    return lines;
}

}  // namespace tedavis::host_sim
