#include "render_core/design/adjacent_view.hpp"

#include "render_core/design/config_values.hpp"

namespace tedavis::design {

const std::array<std::string_view, kAdjacentShows> kAdjacentShowsNames{"uncertainty", "value", "members"};

void read_adjacent_view(base::ConfigSection section, PaletteSource& palettes, AdjacentView& view) {
    if (!section.present()) return;
    view.is_shown = section.boolean("enabled", true);
    view.layer = section.text("layer", "");
    view.attribute = section.text("attribute");
    if (view.layer.cut()) fault_of(section, "layer", "is longer than 31 bytes; no layer has such a name");
    if (view.attribute.cut()) fault_of(section, "attribute", "is longer than 31 bytes; no attribute has such a name");
    if (section.has("layer") == section.has("role")) fault_of(section, "layer", "or 'role' says what is shown; give one of them");
    section.choose("role", scene::kLayerRoleNames, view.role);
    section.choose("shows", kAdjacentShowsNames, view.shows);
    view.range_m = section.number("range_m", 500, 1'000'000, view.range_m);
    view.size = section.number("size", 1.5, 5, view.shows == AdjacentShows::members ? 2.5 : view.size);
    view.cells = static_cast<std::uint32_t>(section.integer("cells", kMinCells, kMaxCells, view.cells));
    if (section.has("height_m")) view.height_m = section.number("height_m", -1000, 100'000);
    read_scale(section, palettes, view.scale);
    if (view.scale.palette.is_nominal()) fault_of(section, "palette", "is nominal, and maps show numbers; name another");
}

}  // namespace tedavis::design
