/// Runways of OurAirports (runways.csv): lines from one end to the other.
///
/// Fields: name ("LSZS 03/21"), airport, ident, length_m, width_m, surface, lighted (0 or 1), le_threshold_m and
/// he_threshold_m (how far thresholds are displaced). Heights of the ends above mean sea level; where only one end states its own
/// it serves for both, and without any the runway lies on the ground. Closed runways and those without places are left out and
/// noted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// By the columns that the first line names.
[[nodiscard]] bool is_runway_table(std::string_view text);
/// Throws UserError with file and row where a place is none.
[[nodiscard]] SourceFeatures read_runway_file(const std::string& file);

/// What a layer of runways shows where its recipe binds nothing: length and width.
[[nodiscard]] std::vector<AttributeRecipe> usual_attributes_of_runways();

}  // namespace tedavis::host_sim
