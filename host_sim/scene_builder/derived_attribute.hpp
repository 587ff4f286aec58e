/// Attributes that the scene builder computes for the points of lines: `variable = "derived:cross_wind"` and its like.
///
/// Speeds and tracks are those between the points before and behind (at a line's ends, and beside points without a time, of what
/// there is); a track needs at least kMinTrack_m of way. Wind is interpolated (scene/grid_field.hpp) in the layer that
/// `wind_layer` names, at each point's place, height and time, or at `wind_time`; outside of that grid, and of its times where it
/// has several, it is missing. Its uncertainty comes along: of standard deviations, intervals and percents by their parts along
/// and across the track, of classes the worse; of two kinds it is unknown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

inline constexpr double kMinTrack_m = 50;

enum class DerivedQuantity : std::uint8_t { cross_wind, cross_wind_speed, head_wind, wind_speed, ground_speed, vertical_speed };

[[nodiscard]] bool is_derived(const AttributeRecipe& recipe);
/// The recipe without them.
[[nodiscard]] LayerRecipe without_derived(const LayerRecipe& recipe);

/// Puts them into the draft of the recipe's layer, at their places among its attributes. `layers` are all of the scene. Returns
/// notes; throws UserError.
std::vector<std::string> add_derived(const LayerRecipe& recipe, LayerDraft& layer, const std::vector<LayerDraft>& layers);

}  // namespace tedavis::host_sim
