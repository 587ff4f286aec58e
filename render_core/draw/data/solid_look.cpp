#include "render_core/draw/data/solid_look.hpp"

#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {
namespace {

SolidFading fading_of(design::ElementUncertainty uncertainty) {
    switch (uncertainty) {
        case design::ElementUncertainty::transparency: return SolidFading::transparency;
        case design::ElementUncertainty::saturation: return SolidFading::saturation;
        default: return SolidFading::none;
    }
}

}  // namespace

SolidLook look_of(const ElementInput& input) {
    const design::DataElement& element = input.element;
    SolidLook look;
    look.opacity = static_cast<float>(element.opacity);
    look.ghost = static_cast<float>(element.ghost);
    look.fading = fading_of(element.uncertainty);
    look.has_grid = element.grid;
    look.fading_strength = static_cast<float>(element.uncertainty_strength);
    look.fading_levels = static_cast<float>(element.uncertainty_levels);
    look.growth_per_hour = static_cast<float>(uncertainty_growth_per_hour(input));
    look.group = input.group;
    look.is_mixed = element.opacity < 1 || look.fading == SolidFading::transparency || element.color.alpha < 255;
    return look;
}

}  // namespace tedavis::draw
