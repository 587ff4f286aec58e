#include "render_core/design/data_style.hpp"

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

void read_uncertainty(ConfigSection section, GroundUncertainty& uncertainty) {
    uncertainty.technique = static_cast<IntrinsicUncertainty>(
        section.choice("technique", {kIntrinsicUncertaintyNames.data(), kIntrinsicUncertaintyNames.size()},
                       static_cast<std::size_t>(uncertainty.technique)));
    uncertainty.strength = section.number("strength", 0, 1, uncertainty.strength);
    uncertainty.levels = static_cast<std::uint32_t>(section.integer("levels", 0, kMaxClasses, uncertainty.levels));
    if (uncertainty.levels == 1) fault_of(section, "levels", "must be 0 for continuous, or 2 to 16");
    if (uncertainty.technique == IntrinsicUncertainty::bivariate && uncertainty.levels == 0) uncertainty.levels = 4;
}

void read_ground(ConfigSection section, PaletteSource& palettes, GroundData& ground) {
    if (!section.present()) return;
    ground.is_shown = section.boolean("enabled", true);
    ground.layer = section.text("layer");
    ground.attribute = section.text("attribute");
    if (ground.layer.cut()) fault_of(section, "layer", "is longer than 31 bytes; no layer has such a name");
    if (ground.attribute.cut()) fault_of(section, "attribute", "is longer than 31 bytes; no attribute has such a name");
    read_scale(section, palettes, ground.scale);
    ground.opacity = section.number("opacity", 0, 1, ground.opacity);
    ground.height_m = section.number("height_m", -1000, 100'000, ground.height_m);
    read_uncertainty(section.section("uncertainty"), ground.uncertainty);
}

}  // namespace

const std::array<std::string_view, kIntrinsicUncertainties> kIntrinsicUncertaintyNames{"none",  "transparency", "saturation",
                                                                                       "noise", "strokes",      "bivariate"};

void read_data_style(ConfigSection data, PaletteSource& palettes, DataStyle& style) {
    if (!data.present()) return;
    style.stale_after_s = 60 * data.number("stale_after_min", 1, 100'000, style.stale_after_s / 60);
    read_ground(data.section("ground"), palettes, style.ground);
    read_data_elements(data, palettes, style.elements);
}

bool same_programs(const DataStyle& a, const DataStyle& b) noexcept {
    return a.ground.is_shown == b.ground.is_shown &&
           (!a.ground.is_shown || a.ground.uncertainty.technique == b.ground.uncertainty.technique);
}

}  // namespace tedavis::design
