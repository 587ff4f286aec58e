#include "host_sim/commands/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host_sim/calendar_time.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/scene_builder/scene_build.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

/// What values and uncertainties of an attribute are like, over all that it has.
struct AttributeSummary {
    std::size_t values = 0, missing = 0, interpolated = 0;
    std::size_t unknown = 0;         ///< values of unknown uncertainty
    double least = 1, greatest = 0;  ///< levels of the others

    explicit AttributeSummary(const scene::Attribute& attribute) : values(attribute.values.size()) {
        for (std::size_t n = 0; n < values; ++n) {
            const scene::ValueState state = attribute.state(n);
            missing += state == scene::ValueState::missing ? 1 : 0;
            interpolated += state == scene::ValueState::interpolated ? 1 : 0;
            if (state == scene::ValueState::missing) continue;
            const scene::Uncertainty uncertainty = attribute.uncertainty(n);
            unknown += uncertainty.is_known() ? 0 : 1;
            if (!uncertainty.is_known()) continue;
            least = std::min(least, uncertainty.level());
            greatest = std::max(greatest, uncertainty.level());
        }
    }
    [[nodiscard]] bool has_values() const { return missing < values; }
    [[nodiscard]] bool has_levels() const { return missing + unknown < values; }
};

Json time_or_null(std::int64_t time_ns, std::int64_t none) { return time_ns == none ? Json(nullptr) : Json(utc_text({time_ns})); }

/// Of a float as a reader writes it: 0.1, not 0.10000000149.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", value);
    return std::strtod(text, nullptr);
}

Json describe(const scene::Attribute& attribute) {
    const scene::AttributeEntry& entry = *attribute.entry;
    const AttributeSummary summary(attribute);
    Json uncertainty = nullptr;
    if (summary.has_levels() || entry.uncertainty_kind != scene::UncertaintyKind::none) {
        uncertainty = {{"kind", kind_name(entry.uncertainty_kind)},
                       {"scope", scope_name(entry.uncertainty_scope)},
                       {"full", rounded(double{entry.uncertainty_full})},
                       {"growth_per_hour", rounded(double{entry.uncertainty_growth_per_hour})},
                       {"least", summary.has_levels() ? Json(rounded(summary.least)) : Json(nullptr)},
                       {"greatest", summary.has_levels() ? Json(rounded(summary.greatest)) : Json(nullptr)},
                       {"unknown", summary.unknown}};
    }
    Json json = {{"name", entry.name},
                 {"unit", entry.unit},
                 {"scale", scale_name(entry.scale)},
                 {"of", entry.of == scene::AttributeOf::feature ? "feature" : "point"},
                 {"min", summary.has_values() ? Json(rounded(double{entry.minimum})) : Json(nullptr)},
                 {"max", summary.has_values() ? Json(rounded(double{entry.maximum})) : Json(nullptr)},
                 {"missing", summary.missing},
                 {"interpolated", summary.interpolated},
                 {"uncertainty", uncertainty}};
    if (entry.member_count > 0) json["members"] = entry.member_count;
    if (entry.class_count > 0) json["classes"] = Json::array();
    for (std::uint32_t n = 0; n < entry.class_count; ++n) json["classes"].push_back(std::string(attribute.class_name(n)));
    return json;
}

Json describe(const scene::Layer& layer) {
    const scene::LayerEntry& entry = *layer.entry;
    Json attributes = Json::array();
    for (const scene::Attribute& attribute : layer.attributes) attributes.push_back(describe(attribute));
    Json json = {{"name", entry.name},
                 {"title", entry.title},
                 {"role", scene::name_of(entry.role)},
                 {"shape", shape_name(entry.shape)},
                 {"features", entry.feature_count},
                 {"points", entry.point_count},
                 {"attributes", attributes},
                 {"data_time", time_or_null(entry.data_time_ns, scene::kNoTime)},
                 {"valid_until", time_or_null(entry.valid_until_ns, INT64_MAX)},
                 {"source", entry.source}};
    if (entry.shape == scene::LayerShape::grid)
        json["grid"] = {
            {"columns", entry.grid.columns},
            {"rows", entry.grid.rows},
            {"levels", entry.grid.levels},
            {"times", entry.grid.times},
            {"first_time", layer.times_ns.empty() ? Json(nullptr) : Json(utc_text({layer.times_ns[0]}))},
            {"last_time", layer.times_ns.empty() ? Json(nullptr) : Json(utc_text({layer.times_ns[layer.times_ns.size() - 1]}))}};
    return json;
}

Json describe(const scene::Scene& scene) {
    Json layers = Json::array();
    for (const scene::Layer& layer : scene.layers()) layers.push_back(describe(layer));
    return {{"name", scene.header().name},
            {"origin", scene.header().origin},
            {"revision", scene.header().revision},
            {"bytes", scene.header().file_bytes},
            {"layers", layers}};
}

/// In two digits, so that only what is 0 reads as 0.
std::string level_text(double level) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", level);
    return text;
}

std::string with_unit(double value, const char* unit) {
    std::ostringstream text;
    text << value << (unit[0] != 0 ? " " : "") << unit;
    return text.str();
}

/// What the uncertainty that counts as 1 is measured in.
const char* unit_of_uncertainty(const scene::AttributeEntry& entry) {
    switch (entry.uncertainty_kind) {
        case scene::UncertaintyKind::percent: return "%";
        case scene::UncertaintyKind::ordinal: return "";
        default: return entry.unit;
    }
}

void write_in_words(std::ostream& text, const scene::Attribute& attribute) {
    const scene::AttributeEntry& entry = *attribute.entry;
    const AttributeSummary summary(attribute);
    text << "\n    " << entry.name << ": ";
    if (!summary.has_values())
        text << "no values";
    else if (entry.class_count > 0)
        text << entry.class_count << " classes";
    else
        text << entry.minimum << " .. " << with_unit(double{entry.maximum}, entry.unit);
    if (entry.member_count > 0) text << ", " << int{entry.member_count} << " members";
    if (summary.missing > 0) text << ", " << summary.missing << " missing";
    if (summary.interpolated > 0) text << ", " << summary.interpolated << " interpolated";
    if (summary.has_levels())
        text << "; " << kind_name(entry.uncertainty_kind) << " " << level_text(summary.least) << " .. "
             << level_text(summary.greatest) << " of " << with_unit(double{entry.uncertainty_full}, unit_of_uncertainty(entry));
    else if (entry.uncertainty_kind == scene::UncertaintyKind::none || !summary.has_values())
        text << "; uncertainty not stated";
    if (summary.unknown > 0 && entry.uncertainty_kind != scene::UncertaintyKind::none)
        text << (summary.has_levels() ? ", " : "; uncertainty ") << "unknown for " << summary.unknown;
}

/// Whether it has times after that of its data, as the display tells a forecast from what was measured.
bool has_forecast(const scene::Layer& layer) {
    return !layer.times_ns.empty() && layer.entry->data_time_ns < layer.times_ns[layer.times_ns.size() - 1];
}

void write_in_words(std::ostream& text, const scene::Layer& layer) {
    const scene::LayerEntry& entry = *layer.entry;
    text << "\n  " << entry.name << " (" << scene::name_of(entry.role) << "): ";
    if (entry.shape != scene::LayerShape::grid)
        text << entry.feature_count << " " << shape_name(entry.shape);
    else
        text << entry.grid.columns << " x " << entry.grid.rows << " posts, " << entry.grid.levels << " levels, "
             << entry.grid.times << " times";
    if (!layer.times_ns.empty())
        text << " from " << utc_text({layer.times_ns[0]}) << " to " << utc_text({layer.times_ns[layer.times_ns.size() - 1]});
    if (entry.feature_count != entry.point_count) text << " of " << entry.point_count << " points";
    if (entry.data_time_ns != scene::kNoTime)
        text << ", " << (has_forecast(layer) ? "computed " : "") << utc_text({entry.data_time_ns});
    text << ", from " << entry.source;
    for (const scene::Attribute& attribute : layer.attributes) write_in_words(text, attribute);
}

std::string describe_in_words(const scene::Scene& scene, const std::string& path) {
    std::ostringstream text;
    text << path << ": scene " << scene.header().name << ", revision " << scene.header().revision << ", " << scene.layers().size()
         << " layers, " << scene.header().file_bytes << " bytes";
    if (scene.header().origin[0] != 0) text << ", from " << scene.header().origin;
    for (const scene::Layer& layer : scene.layers()) write_in_words(text, layer);
    return text.str();
}

void say(const std::string& path, Console& console) {
    const OpenScene open(path);
    console.result(describe_in_words(open.scene(), path), json_text(describe(open.scene())));
}

}  // namespace

int run_scene_build(const SceneBuildOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const std::string scene_file = resolve_config(options.scene, "scenes");
    const std::vector<std::string> notes =
        build_scene(scene_file, options.output, [&](std::string_view layer, std::size_t done, std::size_t total) {
            console.progress(layer, done, total);
            if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
        });
    console.progress_done();
    for (const std::string& note : notes) console.note("note: " + note);
    say(options.output, console);
    return 0;
}

int run_scene_info(const SceneInfoOptions& options, Console& console) {
    say(options.database, console);
    return 0;
}

}  // namespace tedavis::host_sim
