#include "host_sim/scene_builder/grid_speed.hpp"

#include <cmath>

#include "host_sim/scene_builder/bound_attribute.hpp"
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

ValueState state_of(const AttributeDraft& attribute, std::size_t n) {
    return attribute.states.empty() ? ValueState::valid : attribute.states[n];
}

}  // namespace

AttributeDraft grid_speed(const LayerRecipe& recipe, const AttributeRecipe& attribute, const LayerDraft& layer) {
    if (attribute.variable != "derived:wind_speed")
        throw UserError(recipe.name + ": '" + attribute.variable + "' is for lines; a grid has derived:wind_speed");
    const AttributeDraft &east = require(recipe, layer, "east"), &north = require(recipe, layer, "north");
    AttributeDraft made = bind_attribute(attribute);
    if (made.unit.empty() && attribute.factor == 1) made.unit = "m/s";
    made.uncertainty_kind = east.uncertainty_kind;
    made.uncertainty_full = east.uncertainty_full * std::abs(attribute.factor);
    made.uncertainty_growth_per_hour = east.uncertainty_growth_per_hour;
    for (std::size_t n = 0; n < east.values.size(); ++n) {
        made.values.push_back(bound_value(attribute, std::hypot(double{east.values[n]}, double{north.values[n]})));
        made.uncertainties.push_back(scene::worse(uncertainty_of(east, n), uncertainty_of(north, n)));
        const bool filled = state_of(east, n) == ValueState::interpolated || state_of(north, n) == ValueState::interpolated;
        made.states.push_back(filled ? ValueState::interpolated : ValueState::valid);
    }
    return made;
}

}  // namespace tedavis::host_sim
