/// Converts values of a source to those of an attribute, as its recipe states.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Makes an attribute without values.
[[nodiscard]] AttributeDraft bind_attribute(const AttributeRecipe& recipe);

/// Returns the value in the source's unit: NaN for numbers that mean "no value", and the recipe's undetected_value for the number
/// that means "nothing detected".
[[nodiscard]] double stated_value(const AttributeRecipe& recipe, double stated);
/// Returns a value as the layer stores it; NaN where it is missing or not one of the classes.
[[nodiscard]] float bound_value(const AttributeRecipe& recipe, double stated);
/// Returns the level of uncertainty from what the source states for one value (the spread of its members, or the variable of the
/// recipe), in the attribute's unit; a number in the recipe overrides it. Unknown where the recipe states nothing, and for NaN
/// and numbers out of range: below 0, more than 100 percent, a quality or a class above `full`. A deviation or an interval above
/// `full` has level 1.
[[nodiscard]] scene::Uncertainty bound_uncertainty(const AttributeRecipe& recipe, double stated);

}  // namespace tedavis::host_sim
