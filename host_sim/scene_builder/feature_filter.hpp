/// Which features of a file a layer shows.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// What features of a role are made of; other shapes do not show it. Roles without a shape of their own are points where a
/// feature is one, else what the first feature is (cables between masts are obstacles too).
[[nodiscard]] scene::LayerShape shape_of(scene::LayerRole role, const std::vector<SourceFeature>& features);

/// True where the box round a feature and the region have something in common. Both may lie across the antimeridian; a feature
/// goes from point to point by the shorter way.
[[nodiscard]] bool reaches(const SourceFeature& feature, const RegionRecipe& region);

/// Takes points that are not of the time asked for out of a feature, with their values. Points without a time stay.
void keep_times(SourceFeature& feature, std::optional<std::int64_t> from_ns, std::optional<std::int64_t> until_ns);

}  // namespace tedavis::host_sim
