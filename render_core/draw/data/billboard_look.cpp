#include "render_core/draw/data/billboard_look.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/design/grey_of.hpp"
#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {
namespace {

using design::ElementUncertainty;

constexpr design::Color kText{255, 255, 255};

/// 0..1, in the element's gradations: as solids fade (shaders/solid.vert).
double shown_level(const design::DataElement& element, scene::Uncertainty uncertainty) {
    const double level = uncertainty.level(), levels = element.uncertainty_levels;
    if (levels < 2) return level;
    constexpr double kBelowOne = 0.9999;
    return std::floor(std::min(level, kBelowOne) * levels) / (levels - 1);
}

design::Color with_opacity(design::Color color, double share) {
    color.alpha = static_cast<std::uint8_t>(std::lround(color.alpha * std::clamp(share, 0.0, 1.0)));
    return color;
}

}  // namespace

BillboardLook faded_look(const design::DataElement& element, design::Color color, scene::Uncertainty uncertainty) {
    BillboardLook look{color, kText, 0, element.uncertainty != ElementUncertainty::none && !uncertainty.is_known()};
    const double lost = shown_level(element, uncertainty) * element.uncertainty_strength;
    double shown = 1;
    if (element.uncertainty == ElementUncertainty::transparency) shown = 1 - lost;
    if (element.technique == design::DataTechnique::billboard) shown = std::max(shown, kMinShown);
    if (element.uncertainty == ElementUncertainty::dashed_rim && lost > 0)
        look.dashes = static_cast<float>(1 - (1 - kMinDashes) * lost);
    if (element.uncertainty == ElementUncertainty::saturation)
        look.color = design::blended(look.color, design::grey_of(look.color), lost);
    look.color = with_opacity(look.color, element.opacity * shown);
    look.text = with_opacity(look.text, element.opacity);
    return look;
}

BillboardLook billboard_look(const ElementInput& input, std::size_t n) {
    scene::Uncertainty uncertainty = encoded_uncertainty(input, n);
    const std::int64_t since = input.layer.entry->data_time_ns;
    if (input.has_date && since != scene::kNoTime)
        uncertainty = scene::aged(uncertainty, {input.time_ns - since}, uncertainty_growth_per_hour(input));
    return faded_look(input.element, encoded_color(input, input.element.by_color, n), uncertainty);
}

BillboardText billboard_name(const ElementInput& input, std::uint32_t feature, const BillboardLook& look) {
    BillboardText name(input.layer.name_of(feature));
    if (look.is_unsure) name.append(name.empty() ? "?" : " ?");
    return name;
}

}  // namespace tedavis::draw
