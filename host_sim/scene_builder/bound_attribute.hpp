/// Binds a source's values to an attribute, as a recipe states.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Makes an attribute without values.
[[nodiscard]] AttributeDraft bind_attribute(const AttributeRecipe& recipe);

/// What the source states, in its unit: NaN where that means that there is none, and the value of what was looked for in vain.
[[nodiscard]] double stated_value(const AttributeRecipe& recipe, double stated);
/// Returns a value as the layer stores it; NaN where it is missing or not one of the classes.
[[nodiscard]] float bound_value(const AttributeRecipe& recipe, double stated);
/// A level from what is stated of one value (the spread of its members, the variable of the recipe), in the attribute's unit; the
/// recipe's own number goes before it. Unknown where the recipe says nothing, and for what is no number or beyond its range:
/// below 0, more than 100 percent, a quality or a class above `full`. A deviation or an interval above it is the least sure.
[[nodiscard]] scene::Uncertainty bound_uncertainty(const AttributeRecipe& recipe, double stated);

}  // namespace tedavis::host_sim
