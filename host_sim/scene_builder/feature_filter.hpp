/// Which features of a file a layer shows.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// What features of a role are made of; other shapes do not show it.
[[nodiscard]] scene::LayerShape shape_of(scene::LayerRole role);

/// True where the box round a feature and the region have something in common. Both may lie across the antimeridian; a feature
/// goes from point to point by the shorter way.
[[nodiscard]] bool reaches(const SourceFeature& feature, const RegionRecipe& region);

/// Takes points that are not of the time asked for out of a feature, with their values. Points without a time stay.
void keep_times(SourceFeature& feature, std::optional<std::int64_t> from_ns, std::optional<std::int64_t> until_ns);

}  // namespace tedavis::host_sim
