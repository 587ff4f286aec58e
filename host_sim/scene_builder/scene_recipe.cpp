#include "host_sim/scene_builder/scene_recipe.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "host_sim/calendar_time.hpp"
#include "host_sim/scene_builder/derived_attribute.hpp"
#include "host_sim/scene_builder/fixed_unit.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"

namespace tedavis::host_sim {
namespace {

using base::ConfigSection;

constexpr std::array<std::string_view, 5> kShapes = {"grid", "points", "lines", "areas", "meshes"};
constexpr std::array<std::string_view, 3> kDatums = {"msl", "ellipsoid", "ground"};
constexpr std::array<std::string_view, 3> kScales = {"nominal", "ordinal", "quantitative"};
constexpr std::array<std::string_view, 5> kKinds = {"none", "standard_deviation", "interval", "percent", "ordinal"};
constexpr std::array<std::string_view, 4> kScopes = {"value", "point", "attribute", "data_set"};
constexpr std::array<std::string_view, 2> kMembers = {"none", "bands"};
constexpr double kLarge = 1e12;
constexpr double kHoursOfAYear = 8784;

std::string text(ConfigSection& section, std::string_view key, std::string_view fallback = "") {
    return std::string(section.text(key, fallback));
}

std::vector<std::string> texts(ConfigSection& section, std::string_view key) {
    std::array<std::string_view, scene::kMaxClasses> found;
    const std::size_t count = section.texts(key, {found.data(), found.size()});
    std::vector<std::string> all;
    for (std::size_t n = 0; n < count && n < found.size(); ++n) all.emplace_back(found[n]);
    return all;
}

std::optional<double> number(ConfigSection& section, std::string_view key) {
    if (!section.has(key)) return std::nullopt;
    return section.number(key, -kLarge, kLarge);
}

std::optional<std::int64_t> instant(ConfigSection& section, std::string_view key) {
    if (!section.has(key)) return std::nullopt;
    const std::optional<base::Time> time = parse_iso8601(section.text(key));
    if (!time) section.fault(key, "no time such as 2026-06-01T14:00:00Z");
    return time ? std::optional(time->ns) : std::nullopt;
}

RegionRecipe read_region(ConfigSection section) {
    RegionRecipe region;
    region.west_deg = section.number("west_deg", -360, 360);
    region.south_deg = section.number("south_deg", -90, 90);
    region.east_deg = section.number("east_deg", -360, 360);
    region.north_deg = section.number("north_deg", -90, 90);
    if (!(region.south_deg < region.north_deg)) section.fault("south_deg", "must be below north_deg");
    return region;
}

/// A spread is what members have; nothing else may be taken for it.
void hold_to_spread(ConfigSection& section, const UncertaintyRecipe& uncertainty, const LayerRecipe& layer) {
    if (!uncertainty.is_spread) return;
    if (layer.members == kMembers[0])
        section.fault(
            "is_spread",
            "'is_spread' is that of an ensemble's members, and the layer names none; give members = \"bands\", or say how "
            "unsure it is by 'value' or 'variable'");
    if (uncertainty.kind != scene::UncertaintyKind::standard_deviation)
        section.fault("is_spread", "'is_spread' is a standard deviation; give kind = \"standard_deviation\"");
    if (uncertainty.is_quality) section.fault("is_quality", "'is_spread' says how unsure, not how sure; leave 'is_quality' out");
}

UncertaintyRecipe read_uncertainty(ConfigSection section, const LayerRecipe& layer) {
    UncertaintyRecipe uncertainty;
    if (!section.present()) return uncertainty;
    section.choose("kind", kKinds, uncertainty.kind);
    section.choose("scope", kScopes, uncertainty.scope);
    uncertainty.variable = text(section, "variable");
    uncertainty.source = text(section, "source");
    uncertainty.value = number(section, "value");
    uncertainty.classes = texts(section, "classes");
    if (!uncertainty.classes.empty() && (uncertainty.classes.size() < 2 || uncertainty.variable.empty()))
        section.fault("classes", "two or more names are needed, and the 'variable' that holds them; give both");
    uncertainty.is_quality = section.boolean("is_quality", false);
    uncertainty.is_spread = section.boolean("is_spread", false);
    uncertainty.full = section.number("full", 1e-9, kLarge, 1);
    uncertainty.growth_per_hour = section.number("growth_per_hour", 0, 1000, 0);
    const int stated = (uncertainty.variable.empty() ? 0 : 1) + (uncertainty.value ? 1 : 0) + (uncertainty.is_spread ? 1 : 0);
    if (uncertainty.kind != scene::UncertaintyKind::none && stated != 1)
        section.fault("kind", "one of 'value', 'variable' and 'is_spread = true' must say how large it is");
    if (uncertainty.is_quality && !uncertainty.classes.empty())
        section.fault("is_quality", "'classes' stand from certain to wholly unsure already; leave 'is_quality' out");
    hold_to_spread(section, uncertainty, layer);
    return uncertainty;
}

/// What is drawn as so many metres is not called feet.
void hold_to_unit(ConfigSection& section, scene::LayerRole role, AttributeRecipe& attribute) {
    const bool is_plain_speed = is_derived(attribute) && attribute.factor == 1;
    const std::string unit(is_plain_speed ? "m/s" : fixed_unit(role, attribute.name));
    if (unit.empty() || attribute.scale != scene::AttributeScale::quantitative) return;
    if (attribute.unit.empty()) attribute.unit = unit;
    if (attribute.unit == unit) return;
    if (is_plain_speed)
        return section.fault("unit", "'" + attribute.variable + "' is in m/s; give unit = \"m/s\", or the 'factor' that makes " +
                                         attribute.unit + " of them");
    std::string advice = "the factor that makes " + unit + " of what the source states";
    if (const std::optional<double> factor = factor_between(attribute.unit, unit); factor && attribute.factor == 1) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.9g", *factor);
        advice = "factor = " + std::string(text.data());
    }
    section.fault("unit", "'" + attribute.name + "' of this role is in " + unit + ", not in '" + attribute.unit +
                              "'; give unit = \"" + unit + "\" and " + advice);
}

AttributeRecipe read_attribute(ConfigSection section, const LayerRecipe& layer) {
    AttributeRecipe attribute;
    attribute.name = std::string(section.text("name"));
    // A longer name than a title may be has none, and legends show the name itself.
    const bool can_be_title = attribute.name.size() < sizeof(scene::AttributeEntry::title);
    attribute.title = text(section, "title", can_be_title ? attribute.name : "");
    attribute.unit = text(section, "unit");
    attribute.variable = text(section, "variable", attribute.name);
    section.choose("scale", kScales, attribute.scale);
    attribute.classes = texts(section, "classes");
    const bool is_classed = attribute.scale != scene::AttributeScale::quantitative;
    if (is_classed == attribute.classes.empty())
        section.fault("scale", is_classed ? "nominal and ordinal attributes need 'classes', their names in order"
                                          : "a quantitative attribute has no 'classes'");
    attribute.class_values.resize(section.element_count("class_values"));
    section.numbers("class_values", -kLarge, kLarge, {attribute.class_values.data(), attribute.class_values.size()});
    if (!attribute.class_values.empty() && attribute.class_values.size() != attribute.classes.size())
        section.fault("class_values", "one number for each name in 'classes' is needed");
    attribute.factor = section.number("factor", -kLarge, kLarge, 1);
    if (attribute.factor == 0) section.fault("factor", "must not be 0, for all values and their spread would be lost");
    attribute.offset = section.number("offset", -kLarge, kLarge, 0);
    attribute.missing.resize(section.element_count("missing"));
    section.numbers("missing", -kLarge, kLarge, {attribute.missing.data(), attribute.missing.size()});
    attribute.undetected = number(section, "undetected");
    if (attribute.undetected) attribute.undetected_value = section.number("undetected_value", -kLarge, kLarge);
    attribute.least = number(section, "least");
    attribute.most = number(section, "most");
    hold_to_unit(section, layer.role, attribute);
    attribute.uncertainty = read_uncertainty(section.section("uncertainty"), layer);
    return attribute;
}

PreparationRecipe read_preparation(ConfigSection section) {
    PreparationRecipe prepare;
    if (!section.present()) return prepare;
    if (ConfigSection region = section.section("region"); region.present()) prepare.region = read_region(region);
    prepare.fill_cells = section.number("fill_cells", 0, 64, 0);
    prepare.fill_uncertainty = section.number("fill_uncertainty", 0, 1, prepare.fill_uncertainty);
    prepare.smooth_cells = section.number("smooth_cells", 0, 16, 0);
    prepare.keep_attribute = text(section, "keep_attribute");
    if (!prepare.keep_attribute.empty()) {
        prepare.keep_least = section.number("keep_least", -kLarge, kLarge, -kLarge);
        prepare.keep_most = section.number("keep_most", -kLarge, kLarge, kLarge);
    }
    return prepare;
}

void read_times(ConfigSection& section, LayerRecipe& layer) {
    layer.data_time_ns = instant(section, "data_time");
    layer.from_ns = instant(section, "from");
    layer.until_ns = instant(section, "until");
    if (layer.from_ns && layer.until_ns && *layer.from_ns > *layer.until_ns) section.fault("from", "must not be after 'until'");
    layer.valid_hours = section.number("valid_hours", 0, kHoursOfAYear, 0);
}

void read_heights(ConfigSection& section, LayerRecipe& layer) {
    if (section.has("height_datum")) section.choose("height_datum", kDatums, layer.height_datum.emplace());
    layer.aircraft = text(section, "aircraft");
    layer.name_variable = text(section, "name_variable", layer.name_variable);
    layer.time_variable = text(section, "time_variable");
    layer.height_variable = text(section, "height_variable");
    layer.height_factor = section.number("height_factor", -1000, 1000, 1);
    layer.levels.resize(section.element_count("levels"));
    section.numbers("levels", 0, 1e6, {layer.levels.data(), layer.levels.size()});
    layer.heights_m.resize(section.element_count("heights_m"));
    section.numbers("heights_m", -1000, 100000, {layer.heights_m.data(), layer.heights_m.size()});
}

LayerRecipe read_layer(ConfigSection section) {
    LayerRecipe layer;
    layer.name = std::string(section.text("name"));
    layer.title = text(section, "title", layer.name);
    layer.source = std::string(section.text("source"));
    layer.licence = text(section, "licence");
    section.choose("role", scene::kLayerRoleNames, layer.role);
    layer.importance = static_cast<std::uint8_t>(section.integer("importance", 0, 255, 128));
    read_times(section, layer);
    read_heights(section, layer);
    layer.position_accuracy_m = section.number("position_accuracy_m", 0, 1e6, 0);
    layer.height_accuracy_m = section.number("height_accuracy_m", 0, 1e5, 0);
    layer.crs = text(section, "crs");
    layer.model = text(section, "model");
    layer.wind_layer = text(section, "wind_layer");
    layer.wind_time_ns = instant(section, "wind_time");
    std::size_t members = 0;
    section.choose("members", kMembers, members);
    layer.members = std::string(kMembers[members]);
    layer.keep_members = static_cast<std::size_t>(section.integer("keep_members", 0, scene::kMaxMembers, 0));
    if (layer.keep_members == 1) section.fault("keep_members", "must be 0, or 2 to 16: one member alone is no ensemble");
    if (layer.keep_members > 0 && layer.members == "none")
        section.fault("keep_members", "needs members = \"bands\", which says where members come from");
    if (section.has("raster_m")) layer.raster_m = section.number("raster_m", 1, 100'000);
    layer.prepare = read_preparation(section.section("prepare"));
    for (std::size_t n = 0; n < section.table_count("attribute"); ++n)
        layer.attributes.push_back(read_attribute(section.table_at("attribute", n), layer));
    return layer;
}

}  // namespace

std::string_view shape_name(scene::LayerShape shape) { return kShapes[static_cast<std::size_t>(shape)]; }
std::string_view scale_name(scene::AttributeScale scale) { return kScales[static_cast<std::size_t>(scale)]; }
std::string_view kind_name(scene::UncertaintyKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }
std::string_view scope_name(scene::UncertaintyScope scope) { return kScopes[static_cast<std::size_t>(scope)]; }

SceneRecipe parse_scene(std::string_view content, const std::string& file_name) {
    if (content.find('\0') != std::string_view::npos)
        throw UserError(file_name +
                        ": is no scene file, which is TOML text; see what data hold by 'tedavis scene look FILE', which "
                        "prints a layer for a scene file");
    base::ConfigReader reader(content, file_name);
    ConfigSection root = reader.root();
    SceneRecipe recipe;
    recipe.name = std::string(root.text("name"));
    recipe.origin = text(root, "origin");
    const std::size_t layers = root.table_count("layer");
    if (layers == 0 || layers > scene::kMaxLayers)
        root.fault("layer", "1 to 32 tables [[layer]] are needed; add one for each source");
    for (std::size_t n = 0; n < layers && n < scene::kMaxLayers; ++n)
        recipe.layers.push_back(read_layer(root.table_at("layer", n)));
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    return recipe;
}

}  // namespace tedavis::host_sim
