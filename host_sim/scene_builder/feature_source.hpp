/// Features of any file that is no raster, by the reader of its format.
#pragma once

#include <string>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"
#include "host_sim/scene_builder/source_kind.hpp"

namespace tedavis::host_sim {

struct FeatureSource {
    SourceFeatures features;
    std::vector<AttributeRecipe> usual_attributes;  ///< used if the recipe states none
};

/// Reads the file at `path`, which is of `kind` and no grid. Of the recipe it uses `aircraft`, `crs` and `raster_m`. Throws
/// UserError.
[[nodiscard]] FeatureSource read_feature_source(SourceKind kind, const LayerRecipe& recipe, const std::string& path);

}  // namespace tedavis::host_sim
