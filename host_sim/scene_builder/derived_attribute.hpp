/// Attributes that the scene builder computes for the points of lines: `variable = "derived:cross_wind"` and its like.
///
/// Speeds and tracks are computed between the points before and after (at a line's ends, and beside points without a time, from
/// the available ones); a track needs at least kMinTrack_m of distance. Wind is interpolated (scene/grid_field.hpp) in the layer
/// that `wind_layer` names, at each point's place, height and time, or at `wind_time`; it is missing outside of that grid, and of
/// its times if it has several. Its uncertainty is propagated: standard deviations, intervals and percents by their components
/// along and across the track, classes as the worse of both; with two different kinds it is unknown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

inline constexpr double kMinTrack_m = 50;

enum class DerivedQuantity : std::uint8_t { cross_wind, cross_wind_speed, head_wind, wind_speed, ground_speed, vertical_speed };

[[nodiscard]] bool is_derived(const AttributeRecipe& recipe);
/// Returns the recipe without derived attributes.
[[nodiscard]] LayerRecipe without_derived(const LayerRecipe& recipe);

/// Adds the derived attributes to the draft of the recipe's layer, at their places among its attributes. `layers` are all layers
/// of the scene. Returns notes; throws UserError.
std::vector<std::string> add_derived(const LayerRecipe& recipe, LayerDraft& layer, const std::vector<LayerDraft>& layers);

}  // namespace tedavis::host_sim
