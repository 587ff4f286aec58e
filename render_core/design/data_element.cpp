#include "render_core/design/data_element.hpp"

#include <algorithm>

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr double kLargestValue = 1e12;
constexpr std::string_view kOwnDataNames[] = {"trail", "wind"};  // from the second of OwnData on

void read_name(ConfigSection& section, std::string_view key, DataName& name) {
    name = section.text(key, "");
    if (name.cut()) fault_of(section, key, "is longer than 31 bytes; nothing in a scene has such a name");
}

void read_encoding(ConfigSection& section, PaletteSource& palettes, std::string_view attribute, const ScaleKeys& keys,
                   ColorEncoding& encoding) {
    read_name(section, attribute, encoding.attribute);
    if (encoding.is_used()) return read_scale(section, palettes, encoding.scale, keys);
    if (section.has(keys.palette)) fault_of(section, keys.palette, "has no attribute to colour; name one");
}

template <std::size_t N>
void read_list(ConfigSection& section, std::string_view key, double low, double high, base::FixedVector<double, N>& list) {
    double values[N]{};
    const std::size_t count = section.element_count(key);
    if (count > N) return fault_of(section, key, "has too many values");
    section.numbers(key, low, high, {values, count});
    list.clear();
    for (std::size_t n = 0; n < count; ++n) static_cast<void>(list.try_push_back(values[n]));
}

bool is_surface(DataTechnique technique) {
    switch (technique) {
        case DataTechnique::tube:
        case DataTechnique::space_time:
        case DataTechnique::prism:
        case DataTechnique::solid:
        case DataTechnique::ribbon:
        case DataTechnique::isosurface: return true;
        default: return false;
    }
}

/// Tubes, pathways and areas have their own heights, and solids and ribbons stand on the ground.
bool may_float(DataTechnique technique) { return !is_surface(technique) && technique != DataTechnique::pathway; }

/// Lines that may have a height of their own.
bool may_have_cues(DataTechnique technique) {
    return technique == DataTechnique::tube || technique == DataTechnique::space_time || technique == DataTechnique::ribbon;
}

void read_cues(ConfigSection& section, DataElement& element) {
    read_element_cues(section.section("cues"), element.cues);
    if (!section.has("cues")) return;
    if (!may_have_cues(element.technique))
        return fault_of(section, "cues", "are for the techniques 'tube', 'space_time' and 'ribbon'; leave them out here");
    if (element.technique == DataTechnique::ribbon && element.cues.projection > 0)
        return fault_of(section, "cues", "has a 'projection', and a ribbon lies on the ground already; leave it out");
    if (!element.cues.is_any()) fault_of(section, "cues", "asks for nothing; give 'line_spacing_m', 'projection' or 'curtain'");
}

void read_uncertainty(ConfigSection section, DataElement& element) {
    section.choose("technique", kElementUncertaintyNames, element.uncertainty);
    element.uncertainty_strength = section.number("strength", 0, 1, element.uncertainty_strength);
    element.uncertainty_levels = static_cast<std::uint32_t>(section.integer("levels", 0, kMaxClasses, 0));
    if (element.uncertainty_levels == 1) fault_of(section, "levels", "must be 0 for continuous, or 2 to 16");
}

/// A pathway shows where the path is, in one scale of colours.
void refuse_of_pathway(ConfigSection& section, const DataElement& element) {
    if (element.technique != DataTechnique::pathway) return;
    if (element.own != OwnData::none)
        return fault_of(section, "technique", "'pathway' is for what is planned; show the own flight as 'tube' or 'ribbon'");
    for (const std::string_view key : {"second_attribute", "size_attribute"})
        if (section.has(key)) return fault_of(section, key, "does not apply to the technique 'pathway'; leave it out here");
}

void read_layer(ConfigSection& section, DataElement& element) {
    read_name(section, "layer", element.layer);
    const bool has_layer = section.has("layer"), has_role = section.has("role"), has_own = section.has("own");
    if (int{has_layer} + int{has_role} + int{has_own} != 1)
        return fault_of(section, "layer", "or 'role' or 'own' says what is shown; give one of them");
    section.choose("own", kOwnDataNames, element.own, OwnData::trail);
    section.choose("role", scene::kLayerRoleNames, element.role);
}

/// Glyphs stand for the mean of several places, and of kinds there is none.
bool may_show_kinds(DataTechnique technique) {
    switch (technique) {
        case DataTechnique::prism:
        case DataTechnique::solid:
        case DataTechnique::ribbon:
        case DataTechnique::billboard: return true;
        default: return false;
    }
}

/// Designs that are based on this one find an element by its name.
void refuse_equal_names(ConfigSection& data) {
    std::string_view names[kMaxDataElements];
    const std::size_t count = std::min(data.table_count("element"), kMaxDataElements);
    for (std::size_t n = 0; n < count; ++n) {
        ConfigSection element = data.table_at("element", n);
        names[n] = element.text("name", "");
        if (!names[n].empty() && std::find(names, names + n, names[n]) != names + n)
            return fault_of(element, "name", "is taken by another element; give it another one");
    }
}

DataElement read_element(ConfigSection section, PaletteSource& palettes) {
    DataElement element;
    read_layer(section, element);
    section.choose("technique", kDataTechniqueNames, element.technique);
    if (section.has("color")) element.color = required_color(section, "color");
    read_encoding(section, palettes, "attribute", {}, element.by_color);
    read_encoding(section, palettes, "second_attribute", {"second_palette", "second_classes", "second_breaks"},
                  element.by_second_color);
    if (element.by_color.scale.palette.is_nominal() && !may_show_kinds(element.technique))
        fault_of(section, "palette", "is nominal, and this technique shows numbers; name another");
    if (element.by_second_color.scale.palette.is_nominal())
        fault_of(section, "second_palette", "is nominal, and tubes show numbers; name another");
    read_name(section, "size_attribute", element.size_attribute);
    element.size_m = section.number("size_m", 0, 100'000, element.size_m);
    read_list(section, "heights_m", -1000, 100'000, element.heights_m);
    element.heights_over_ground = section.boolean("heights_over_ground", false);
    if (element.heights_over_ground && element.heights_m.empty())
        section.fault("heights_over_ground", "says what 'heights_m' are above, and there are none; state them");
    read_list(section, "levels", -kLargestValue, kLargestValue, element.levels);
    element.opacity = section.number("opacity", 0, 1, element.opacity);
    element.ghost = section.number("ghost", 0, 1, element.ghost);
    element.halo_px = section.number("halo_px", 0, 20, element.halo_px);
    element.grid = section.boolean("grid", element.grid);
    if (element.grid && !is_surface(element.technique))
        fault_of(section, "grid",
                 "is for tubes, prisms, solids, ribbons and isosurfaces, which have a surface; leave it out here");
    element.link = section.boolean("link", element.link);
    if (element.link && !may_float(element.technique))
        fault_of(section, "link", "is for signs, diagrams and glyphs, which float over a place; leave it out here");
    element.detail = section.number("detail", 0, 1, element.detail);
    read_uncertainty(section.section("uncertainty"), element);
    if (element.uncertainty == ElementUncertainty::dashed_rim && element.technique != DataTechnique::billboard)
        fault_of(section, "uncertainty", "'dashed_rim' is for the technique 'billboard'; choose another one");
    read_cues(section, element);
    refuse_of_pathway(section, element);
    return element;
}

}  // namespace

const std::array<std::string_view, kDataTechniques> kDataTechniqueNames{
    "tube",   "pathway",     "space_time", "prism",   "solid", "ribbon",     "billboard",       "diagram",
    "arrows", "flat_arrows", "barbs",      "spheres", "bars",  "isosurface", "uncertainty_only"};
const std::array<std::string_view, kElementUncertainties> kElementUncertaintyNames{
    "none", "transparency", "saturation", "widening", "ellipsoid", "circles", "triangles", "tetrahedra", "dashed_rim"};

DataName subject_of(const DataElement& element) noexcept {
    if (element.own == OwnData::none) {
        const bool has_role = element.layer.view().empty() && element.role != scene::LayerRole::count;
        return has_role ? DataName(scene::name_of(element.role)) : element.layer;
    }
    DataName name("own ");
    name.append(kOwnDataNames[static_cast<std::size_t>(element.own) - 1]);
    return name;
}

bool asks_for_own(const DataElementList& elements) noexcept {
    for (const DataElement& element : elements)
        if (element.own != OwnData::none) return true;
    return false;
}

bool asks_for_traffic(const DataElementList& elements) noexcept {
    for (const DataElement& element : elements)
        if (element.role == scene::LayerRole::traffic) return true;
    return false;
}

bool asks_for_grid(const DataElementList& elements) noexcept {
    for (const DataElement& element : elements)
        if (element.grid) return true;
    return false;
}

void read_data_elements(ConfigSection& data, PaletteSource& palettes, DataElementList& elements) {
    refuse_equal_names(data);
    const std::size_t count = data.table_count("element");
    elements.clear();
    for (std::size_t n = 0; n < count; ++n)
        if (!elements.try_push_back(read_element(data.table_at("element", n), palettes)))
            return fault_of(data, "element", "is more often there than a display has room for; keep at most 12");
}

}  // namespace tedavis::design
