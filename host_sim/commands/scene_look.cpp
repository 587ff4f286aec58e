#include "host_sim/commands/scene_look.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "host_sim/calendar_time.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/name_choices.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/scene_builder/kept_unit.hpp"
#include "host_sim/scene_builder/source_look.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using LookJson = nlohmann::ordered_json;

constexpr double kKilometresPerDegree = 111.195;  // of a great circle on the mean sphere of 6371.0088 km

std::string digits(double value) { return printed("%.6g", value); }
double rounded_number(double value) { return std::strtod(printed("%.7g", value).c_str(), nullptr); }

// ---- times

/// In words: "1 h", "5 min", "90 s"; empty where the steps differ.
std::optional<double> even_step_s(const std::vector<std::int64_t>& times_ns) {
    if (times_ns.size() < 2) return std::nullopt;
    const std::int64_t step_ns = times_ns[1] - times_ns[0];
    for (std::size_t n = 2; n < times_ns.size(); ++n)
        if (times_ns[n] - times_ns[n - 1] != step_ns) return std::nullopt;
    return static_cast<double>(step_ns) / 1e9;
}
std::string duration_text(double seconds) {
    if (std::fmod(seconds, 3600) == 0) return digits(seconds / 3600) + " h";
    if (std::fmod(seconds, 60) == 0) return digits(seconds / 60) + " min";
    return digits(seconds) + " s";
}
std::string times_text(const std::vector<std::int64_t>& times_ns) {
    if (times_ns.empty()) return "not stated";
    std::string first = utc_text({times_ns.front()});
    if (times_ns.size() == 1) return first;
    const std::optional<double> step_s = even_step_s(times_ns);
    return first + " to " + utc_text({times_ns.back()}) + ", " + std::to_string(times_ns.size()) + " times, " +
           (step_s ? "every " + duration_text(*step_s) : "uneven steps");
}
LookJson times_json(const std::vector<std::int64_t>& times_ns) {
    if (times_ns.empty()) return nullptr;
    const std::optional<double> step_s = even_step_s(times_ns);
    return {{"first", utc_text({times_ns.front()})},
            {"last", utc_text({times_ns.back()})},
            {"count", times_ns.size()},
            {"step_s", step_s ? LookJson(*step_s) : LookJson(nullptr)}};
}

LookJson range_json(const std::optional<ValueRange>& range) {
    if (!range) return nullptr;
    return {{"min", rounded_number(range->least)}, {"max", rounded_number(range->greatest)}};
}
std::string range_text(const std::optional<ValueRange>& range) {
    return range ? digits(range->least) + " .. " + digits(range->greatest) : "no values";
}
LookJson text_or_null(const std::string& text) { return text.empty() ? LookJson(nullptr) : LookJson(text); }

// ---- grids

struct Spacing {
    double east_km = 0, north_km = 0;
};
Spacing spacing_of(const GridPlaces& places) {
    const double middle_deg = places.north_deg - 0.5 * places.step_lat_deg * (places.rows - 1);
    return {places.step_lon_deg * kKilometresPerDegree * std::cos(base::radians(middle_deg)),
            places.step_lat_deg * kKilometresPerDegree};
}
double east_of(const GridPlaces& places) { return places.west_deg + places.step_lon_deg * (places.columns - 1); }
double south_of(const GridPlaces& places) { return places.north_deg - places.step_lat_deg * (places.rows - 1); }

bool are_same_places(const GridPlaces& a, const GridPlaces& b) {
    return a.columns == b.columns && a.rows == b.rows && a.west_deg == b.west_deg && a.north_deg == b.north_deg;
}

std::string places_text(const GridPlaces& places) {
    const Spacing spacing = spacing_of(places);
    return printed("%d x %d posts, %.6g x %.6g degrees (%.3g x %.3g km), W %.6g S %.6g E %.6g N %.6g", places.columns,
                   places.rows, places.step_lon_deg, places.step_lat_deg, spacing.east_km, spacing.north_km, places.west_deg,
                   south_of(places), east_of(places), places.north_deg);
}
LookJson places_json(const GridPlaces& places) {
    const Spacing spacing = spacing_of(places);
    return {{"columns", places.columns},
            {"rows", places.rows},
            {"step_lon_deg", places.step_lon_deg},
            {"step_lat_deg", places.step_lat_deg},
            {"spacing_east_km", rounded_number(spacing.east_km)},
            {"spacing_north_km", rounded_number(spacing.north_km)},
            {"west_deg", places.west_deg},
            {"south_deg", south_of(places)},
            {"east_deg", east_of(places)},
            {"north_deg", places.north_deg}};
}

std::string levels_text(const VariableLook& variable) {
    if (variable.levels.empty()) return "none";
    std::vector<std::string> names;
    for (const double level : variable.levels) names.push_back(digits(level));
    std::string text = name_choices(names);
    if (!variable.level_unit.empty()) text += " " + variable.level_unit;
    return variable.level_kind.empty() ? text : text + " (" + variable.level_kind + ")";
}

std::string kept_text(const std::string& stated) {
    if (stated.empty()) return "not stated; give 'unit'";
    const KeptUnit kept = kept_unit(stated);
    if (kept.unit == stated) return stated;
    std::string text = stated + "; the scene keeps " + (kept.unit.empty() ? "a plain number" : kept.unit);
    if (kept.factor != 1) text += " (factor " + digits(kept.factor) + ")";
    if (kept.offset != 0) text += " (offset " + digits(kept.offset) + ")";
    return text;
}

std::string members_text(const VariableLook& variable) {
    if (variable.most_members == 1) return "";
    const std::string least = std::to_string(variable.least_members), most = std::to_string(variable.most_members);
    return "members: " + (least == most ? most : least + " to " + most) + " (grids of one time and level)";
}

std::string values_text(const VariableLook& variable) {
    std::string text = range_text(variable.range);
    if (variable.missing_share > 0) text += printed(", %.3g %% missing", 100 * variable.missing_share);
    for (const double number : variable.special) text += printed(", %.9g means no value", number);
    if (variable.undetected) text += printed(", %.9g means nothing detected", *variable.undetected);
    return text;
}

std::string variable_text(const VariableLook& variable, const GridLook& look) {
    std::string text = "\n  " + variable.name + (variable.description.empty() ? "" : ": " + variable.description);
    const auto add = [&text](const std::string& line) { text += "\n    " + line; };
    add("unit: " + kept_text(variable.unit));
    add("levels: " + levels_text(variable) + (variable.is_whole ? "" : "; not every level has every time"));
    add("times: " + times_text(variable.times_ns) +
        (variable.computed_ns ? "; computed " + utc_text({*variable.computed_ns}) : ""));
    if (variable.most_members > 1) add(members_text(variable));
    add("values of the first grid: " + values_text(variable));
    if (!are_same_places(variable.places, look.variables.front().places)) add("grid: " + places_text(variable.places));
    return text;
}

LookJson variable_json(const VariableLook& variable) {
    const KeptUnit kept = kept_unit(variable.unit);
    return {{"name", variable.name},
            {"description", text_or_null(variable.description)},
            {"unit", text_or_null(variable.unit)},
            {"kept_unit", text_or_null(kept.unit)},
            {"factor", kept.factor},
            {"offset", kept.offset},
            {"levels", variable.levels},
            {"level_unit", text_or_null(variable.level_unit)},
            {"level_kind", text_or_null(variable.level_kind)},
            {"every_level_has_every_time", variable.is_whole},
            {"times", times_json(variable.times_ns)},
            {"computed", variable.computed_ns ? LookJson(utc_text({*variable.computed_ns})) : LookJson(nullptr)},
            {"members", {{"least", variable.least_members}, {"most", variable.most_members}}},
            {"first_grid", {{"range", range_json(variable.range)}, {"missing_share", rounded_number(variable.missing_share)}}},
            {"missing", variable.special},
            {"undetected", variable.undetected ? LookJson(*variable.undetected) : LookJson(nullptr)},
            {"grid", places_json(variable.places)}};
}

std::string system_of(const GridLook& look) {
    std::string text = !look.system.empty() ? look.system
                       : look.is_assumed    ? "not stated, taken for longitude and latitude"
                                            : "longitude and latitude, as its axes state";
    if (look.is_warped) text += "; values are interpolated in longitude and latitude";
    return text;
}

std::string grid_text(const GridLook& look) {
    std::string text = "\n  coordinate system: " + system_of(look);
    text += "\n  grid: " + places_text(look.variables.front().places);
    for (const VariableLook& variable : look.variables) text += variable_text(variable, look);
    if (look.more_variables > 0) text += "\n  and " + std::to_string(look.more_variables) + " more variables";
    return text;
}
LookJson grid_json(const GridLook& look) {
    LookJson variables = LookJson::array();
    for (const VariableLook& variable : look.variables) variables.push_back(variable_json(variable));
    return {{"format", look.format},         {"system", text_or_null(look.system)},
            {"is_assumed", look.is_assumed}, {"is_warped", look.is_warped},
            {"variables", variables},        {"more_variables", look.more_variables}};
}

// ---- features

const char* kind_word(ColumnKind kind) {
    switch (kind) {
        case ColumnKind::number: return "number";
        case ColumnKind::time: return "time";
        default: return "text";
    }
}

std::string column_text(const ColumnLook& column) {
    std::string text = "\n    " + column.name + ": ";
    if (column.stated == 0) return text + "never stated";
    text += std::string(kind_word(column.kind)) + (column.is_of_points ? " of each point, " : ", ");
    if (column.kind == ColumnKind::number) text += range_text(column.range);
    if (column.kind == ColumnKind::time) text += column.first + " .. " + column.last;
    if (column.kind == ColumnKind::text)
        text += column.different_texts > kMaxTextsLooked ? std::to_string(column.different_texts) + " different texts"
                                                         : name_choices(column.texts);
    return text + "; stated " + std::to_string(column.stated) + " times";
}
LookJson column_json(const ColumnLook& column) {
    LookJson json = {{"name", column.name},
                     {"type", kind_word(column.kind)},
                     {"of", column.is_of_points ? "point" : "feature"},
                     {"stated", column.stated}};
    if (column.kind == ColumnKind::number) json["range"] = range_json(column.range);
    if (column.kind == ColumnKind::time) json["first"] = column.first, json["last"] = column.last;
    if (column.kind == ColumnKind::text) json["texts"] = column.texts, json["different_texts"] = column.different_texts;
    return json;
}

std::string counts_text(const FeatureLook& look) {
    std::string text;
    const auto add = [&text](std::size_t count, const char* what) {
        if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    add(look.points, "points");
    add(look.lines, "lines");
    add(look.areas, "areas");
    if (text.empty()) return "none";
    return look.lines + look.areas > 0 ? text + " (" + std::to_string(look.places) + " vertices)" : text;
}

std::string attributes_text(const FeatureLook& look) {
    std::vector<std::string> names;
    for (const AttributeRecipe& attribute : look.usual_attributes)
        names.push_back(attribute.name + (attribute.unit.empty() ? "" : " (" + attribute.unit + ")"));
    return name_choices(names);
}

std::string feature_text(const FeatureLook& look) {
    std::string text = "\n  coordinate system: " + (look.system.empty() ? "longitude and latitude" : look.system);
    text += "\n  features: " + counts_text(look);
    if (look.places > 0)
        text += printed("\n  extent: W %.6g S %.6g E %.6g N %.6g", look.west_deg, look.south_deg, look.east_deg, look.north_deg);
    if (look.height_m) text += "\n  heights: " + range_text(look.height_m) + " m";
    if (look.first_ns) text += "\n  times: " + utc_text({*look.first_ns}) + " to " + utc_text({*look.last_ns});
    if (!look.aircraft.empty()) text += "\n  aircraft: " + name_choices(look.aircraft);
    if (!look.usual_attributes.empty()) text += "\n  attributes if the layer names none: " + attributes_text(look);
    if (!look.columns.empty()) text += "\n  columns:";
    for (const ColumnLook& column : look.columns) text += column_text(column);
    for (const std::string& note : look.notes) text += "\n  note: " + note;
    return text;
}

LookJson time_json(const std::optional<std::int64_t>& time_ns) {
    return time_ns ? LookJson(utc_text({*time_ns})) : LookJson(nullptr);
}
LookJson feature_json(const FeatureLook& look) {
    LookJson columns = LookJson::array(), usual = LookJson::array(), extent = nullptr;
    for (const ColumnLook& column : look.columns) columns.push_back(column_json(column));
    for (const AttributeRecipe& attribute : look.usual_attributes)
        usual.push_back({{"name", attribute.name}, {"unit", attribute.unit}});
    if (look.places > 0)
        extent = {{"west_deg", look.west_deg},
                  {"south_deg", look.south_deg},
                  {"east_deg", look.east_deg},
                  {"north_deg", look.north_deg}};
    return {{"format", text_or_null(look.format)},
            {"system", text_or_null(look.system)},
            {"points", look.points},
            {"lines", look.lines},
            {"areas", look.areas},
            {"vertices", look.places},
            {"extent", extent},
            {"height_m", range_json(look.height_m)},
            {"first_time", time_json(look.first_ns)},
            {"last_time", time_json(look.last_ns)},
            {"aircraft", look.aircraft},
            {"usual_attributes", usual},
            {"columns", columns},
            {"notes", look.notes}};
}

// ---- files

std::string look_text(const SourceLook& look) {
    const std::string format = look.grid ? look.grid->format : look.features->format;
    std::string text = look.file + ": " + std::string(kind_text(look.kind)) + (format.empty() ? "" : " (" + format + ")");
    text += look.grid ? grid_text(*look.grid) : feature_text(*look.features);
    return text + "\n\nA layer for a scene file (which begins with a line such as name = \"my_scene\"):\n\n" + look.layer;
}
LookJson look_json(const SourceLook& look) {
    LookJson json = {{"file", look.file}, {"kind", kind_text(look.kind)}};
    if (look.grid) json["grid"] = grid_json(*look.grid);
    if (look.features) json["features"] = feature_json(*look.features);
    json["layer"] = look.layer;
    return json;
}

}  // namespace

int run_scene_look(const SceneLookOptions& options, Console& console) {
    std::string text;
    LookJson files = LookJson::array();
    std::vector<std::string> faults;
    for (const std::string& file : options.files) {
        try {
            const SourceLook look = look_at_source(file, options.crs);
            text += (text.empty() ? "" : "\n") + look_text(look);
            files.push_back(look_json(look));
        } catch (const UserError& fault) {
            if (options.files.size() == 1) throw;
            faults.emplace_back(fault.what());
        }
    }
    if (files.empty()) throw UserError(faults.front());
    for (const std::string& fault : faults) console.note("tedavis: " + fault);
    console.result(text, json_text(LookJson{{"files", files}}));
    return faults.empty() ? 0 : kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
