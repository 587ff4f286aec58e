/// Selects the features of a file for a layer.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// Returns the shape of a role's features; features of other shapes are left out. A role without a fixed shape has points if any
/// feature is a point, else the shape of the first feature (cables between masts are obstacles, too).
[[nodiscard]] scene::LayerShape shape_of(scene::LayerRole role, const std::vector<SourceFeature>& features);

/// True if the bounding box of a feature intersects the region. Both may extend across the antimeridian; a feature goes from
/// point to point by the shorter way.
[[nodiscard]] bool reaches(const SourceFeature& feature, const RegionRecipe& region);

/// Removes the points outside the times from a feature, with their values. Points without a time stay.
void keep_times(SourceFeature& feature, std::optional<std::int64_t> from_ns, std::optional<std::int64_t> until_ns);

}  // namespace tedavis::host_sim
