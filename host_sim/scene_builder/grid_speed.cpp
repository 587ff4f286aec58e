#include "host_sim/scene_builder/grid_speed.hpp"

#include <cmath>

#include "host_sim/scene_builder/bound_attribute.hpp"
#include "host_sim/scene_builder/component_uncertainty.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using scene::Uncertainty;
using scene::ValueState;

const AttributeDraft& require(const LayerRecipe& recipe, const LayerDraft& layer, const char* name) {
    for (const AttributeDraft& attribute : layer.attributes)
        if (attribute.name == name) return attribute;
    throw UserError(recipe.name + ": 'derived:wind_speed' needs the attributes 'east' and 'north' (m/s) of this grid; bind them");
}

Uncertainty uncertainty_of(const AttributeDraft& attribute, std::size_t n) {
    return attribute.uncertainties.empty() ? attribute.uncertainty_all : attribute.uncertainties[n];
}

UncertaintyScale scale_of(const AttributeDraft& attribute) {
    return {attribute.uncertainty_kind, attribute.uncertainty_full, attribute.uncertainty_growth_per_hour};
}

ValueState state_of(const AttributeDraft& attribute, std::size_t n) {
    return attribute.states.empty() ? ValueState::valid : attribute.states[n];
}

}  // namespace

AttributeDraft grid_speed(const LayerRecipe& recipe, const AttributeRecipe& attribute, const LayerDraft& layer) {
    if (attribute.variable != "derived:wind_speed")
        throw UserError(recipe.name + ": '" + attribute.variable + "' is for lines; a grid has derived:wind_speed");
    if (attribute.uncertainty.kind != scene::UncertaintyKind::none)
        throw UserError(recipe.name + ": '" + attribute.variable + "' has the uncertainty of the wind; leave its own out");
    const AttributeDraft &east = require(recipe, layer, "east"), &north = require(recipe, layer, "north");
    AttributeDraft made = bind_attribute(attribute);
    if (made.unit.empty() && attribute.factor == 1) made.unit = "m/s";
    const UncertaintyScale of_east = scale_of(east), of_north = scale_of(north), shared = shared_scale(of_east, of_north);
    made.uncertainty_kind = shared.kind;
    made.uncertainty_full = (is_in_unit_of_values(shared.kind) ? std::abs(attribute.factor) : 1) * shared.full;
    made.uncertainty_growth_per_hour = shared.growth_per_hour;
    for (std::size_t n = 0; n < east.values.size(); ++n) {
        made.values.push_back(bound_value(attribute, std::hypot(double{east.values[n]}, double{north.values[n]})));
        made.uncertainties.push_back(worse_on(shared, uncertainty_of(east, n), of_east, uncertainty_of(north, n), of_north));
        const bool filled = state_of(east, n) == ValueState::interpolated || state_of(north, n) == ValueState::interpolated;
        made.states.push_back(filled ? ValueState::interpolated : ValueState::valid);
    }
    return made;
}

}  // namespace tedavis::host_sim
