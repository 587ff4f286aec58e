#include "render_core/design/symbology_palette.hpp"

#include <algorithm>

#include "render_core/base/check.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr double kMinTypeSize = 0.5, kMaxTypeSize = 2;

constexpr std::array<Color, kSymbolRoleCount> kDayColors = {{{255, 255, 255},
                                                             {255, 48, 48},
                                                             {255, 176, 0},
                                                             {64, 240, 96},
                                                             {0, 224, 255},
                                                             {255, 96, 255},
                                                             {255, 224, 0},
                                                             {0, 0, 0},
                                                             {16, 20, 28, 150},
                                                             {0, 0, 0, 255},
                                                             {10, 12, 16, 184}}};
constexpr std::array<Color, kSymbolRoleCount> kNightColors = {{{176, 180, 184},
                                                               {236, 52, 56},
                                                               {200, 152, 0},
                                                               {60, 160, 92},
                                                               {28, 196, 216},
                                                               {212, 98, 208},
                                                               {220, 196, 60},
                                                               {0, 0, 0},
                                                               {6, 8, 12, 176},
                                                               {0, 0, 0, 255},
                                                               {4, 5, 8, 204}}};

constexpr const char* kEngagedOrReference =
    "the aircraft's symbol and the bank pointer have shapes and places of their own; what is engaged is a bar, or named";

SymbologyPalettes made_default() {
    SymbologyPalettes made;
    made.name = "standard";
    made.of(SymbologyLight::day) = {kDayColors, {}};
    made.of(SymbologyLight::night) = {kNightColors, {}};
    const bool added = made.told_apart.try_push_back({SymbolRole::engaged, SymbolRole::reference, kEngagedOrReference});
    TEDAVIS_CHECK(added);
    return made;
}

void read_light_colors(ConfigSection section, SymbologyPalette& palette) {
    for (std::size_t n = 0; n < kSymbolRoleCount; ++n) {
        const std::string_view role = kSymbolRoleNames[n];
        palette.colors[n] = required_color(section, role);
        const bool may_be_translucent = n > static_cast<std::size_t>(SymbolRole::rim);
        if (!may_be_translucent && palette.colors[n].alpha != 255)
            fault_of(section, role, "is of signs, which are never translucent; write it as \"#rrggbb\"");
    }
}

void read_type_sizes(ConfigSection section, SymbologyType& type) {
    const auto read = [&](std::string_view key, float& size) {
        size = static_cast<float>(section.number(key, kMinTypeSize, kMaxTypeSize, static_cast<double>(size)));
    };
    read("value_large", type.value_large);
    read("value", type.value);
    read("label", type.label);
    if (type.value > type.value_large) fault_of(section, "value", "must not be larger than value_large");
    if (type.label > type.value) fault_of(section, "label", "must not be larger than value");
}

/// The role of a sign; `scale` after a fault.
SymbolRole sign_role(ConfigSection& section, std::string_view name) {
    const auto end = kSymbolRoleNames.begin() + kSignRoleCount;
    const auto found = std::find(kSymbolRoleNames.begin(), end, name);
    if (found != end) return static_cast<SymbolRole>(found - kSymbolRoleNames.begin());
    fault_of(section, "roles",
             "must name two of scale, warning, caution, engaged, selected, gnss_course and reference, such as [\"scale\", "
             "\"reference\"]");
    return SymbolRole::scale;
}

RolesToldApart read_roles_told_apart(ConfigSection section) {
    RolesToldApart pair;
    std::array<std::string_view, 2> names;
    if (section.texts("roles", {names.data(), names.size()}) != names.size()) names = {};
    pair.first = sign_role(section, names[0]);
    pair.second = sign_role(section, names[1]);
    if (pair.first == pair.second) fault_of(section, "roles", "names one role twice; name two");
    pair.by = section.text("by");
    if (pair.by.empty() || pair.by.cut()) fault_of(section, "by", "must say in 1 to 127 characters what tells the roles apart");
    return pair;
}

}  // namespace

const SymbologyPalette kDaySymbology{kDayColors, {}};

const SymbologyPalettes& standard_symbology_palettes() noexcept {
    static const SymbologyPalettes palettes = made_default();
    return palettes;
}

bool SymbologyPalettes::are_told_apart(SymbolRole first, SymbolRole second) const {
    return std::any_of(told_apart.begin(), told_apart.end(), [&](const RolesToldApart& pair) {
        return (pair.first == first && pair.second == second) || (pair.first == second && pair.second == first);
    });
}

base::Result<SymbologyPalettes, base::Error> load_symbology_palettes(std::string_view text, std::string_view file_name) {
    base::ConfigReader reader(text, file_name);
    ConfigSection root = reader.root();
    SymbologyPalettes palettes;
    palettes.name = root.text("name");
    if (palettes.name.empty() || palettes.name.cut()) fault_of(root, "name", "must be 1 to 31 characters long");
    SymbologyType type;
    read_type_sizes(root.section("type"), type);
    for (std::size_t light = 0; light < palettes.lights.size(); ++light) {
        const std::string_view name = kSymbologyLightNames[light];
        if (!root.has(name)) {
            fault_of(root, name, "is missing; state its colors in a table of this name");
            continue;
        }
        read_light_colors(root.section(name), palettes.lights[light]);
        palettes.lights[light].type = type;
    }
    for (std::size_t n = 0; n < root.table_count("told_apart"); ++n) {
        ConfigSection section = root.table_at("told_apart", n);
        if (!palettes.told_apart.try_push_back(read_roles_told_apart(section)))
            fault_of(section, "roles", "is of one pair too many; keep at most 6");
    }
    if (!reader.finish()) return base::fail(reader.error());
    return palettes;
}

}  // namespace tedavis::design
