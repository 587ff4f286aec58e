#include "render_core/design/data_style.hpp"

#include <cmath>

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr double kLargest = 1e12;

/// Equal steps over the palette's range.
void set_classes(DataScale& scale, std::size_t classes) {
    const double low = scale.palette.stops[0].value, high = scale.palette.stops.back().value;
    scale.breaks.clear();
    for (std::size_t n = 1; n < classes; ++n)
        static_cast<void>(scale.breaks.try_push_back(low + (high - low) * static_cast<double>(n) / static_cast<double>(classes)));
}

void read_breaks(ConfigSection& section, DataScale& scale) {
    double breaks[kMaxClasses - 1]{};
    const std::size_t count = section.element_count("breaks");
    if (count > kMaxClasses - 1) return fault_of(section, "breaks", "has too many limits; keep at most 15");
    section.numbers("breaks", -kLargest, kLargest, {breaks, count});
    scale.breaks.clear();
    for (std::size_t n = 0; n < count; ++n) {
        if (n > 0 && !(breaks[n] > breaks[n - 1])) return fault_of(section, "breaks", "must ascend; sort them");
        static_cast<void>(scale.breaks.try_push_back(breaks[n]));
    }
}

void read_scale(ConfigSection& section, PaletteSource& palettes, DataScale& scale) {
    const auto found = palettes.find(section.text("palette"));
    if (!found.ok()) return section.fault("palette", found.error().sentence.view());
    scale.palette = found.value();
    const auto classes = static_cast<std::size_t>(section.integer("classes", 0, kMaxClasses, 0));
    if (section.has("classes") && section.has("breaks"))
        return fault_of(section, "classes", "and 'breaks' both say where classes end; keep one");
    if (classes == 1) return fault_of(section, "classes", "must be 0 for a continuous scale, or 2 to 16");
    if (section.has("breaks"))
        read_breaks(section, scale);
    else
        set_classes(scale, classes);
}

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

std::size_t class_of(const DataScale& scale, double value) noexcept {
    std::size_t number = 0;
    while (number < scale.breaks.size() && value >= scale.breaks[number]) ++number;
    return number;
}

Color color_of_class(const DataScale& scale, std::size_t number) noexcept {
    const double low = scale.palette.stops[0].value, high = scale.palette.stops.back().value;
    if (scale.breaks.empty()) return color_of_value(scale.palette, 0.5 * (low + high));
    const double from = number == 0 ? std::fmin(low, scale.breaks[0]) : scale.breaks[number - 1];
    const double to = number == scale.breaks.size() ? std::fmax(high, scale.breaks.back()) : scale.breaks[number];
    return color_of_value(scale.palette, 0.5 * (from + to));
}

Color scale_color(const DataScale& scale, double value) noexcept {
    return scale.breaks.empty() ? color_of_value(scale.palette, value) : color_of_class(scale, class_of(scale, value));
}

void read_data_style(ConfigSection data, PaletteSource& palettes, DataStyle& style) {
    if (data.present()) read_ground(data.section("ground"), palettes, style.ground);
}

bool same_programs(const DataStyle& a, const DataStyle& b) noexcept {
    return a.ground.is_shown == b.ground.is_shown &&
           (!a.ground.is_shown || a.ground.uncertainty.technique == b.ground.uncertainty.technique);
}

}  // namespace tedavis::design
