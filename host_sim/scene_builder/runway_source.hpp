/// Runways of OurAirports (runways.csv): lines from one end to the other.
///
/// Fields: name ("LSZS 03/21"), airport, ident, length_m, width_m, surface, lighted (0 or 1), le_threshold_m and he_threshold_m
/// (how far thresholds are displaced), and glide_path_deg (1 to 10, of the approach lights of both ends), a column that may be
/// added to such a file. Heights of the ends above mean sea level; where only one end states a height, it is used for both, and
/// without any the runway lies on the ground. Closed runways and those without places are left out and noted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// True if the first line has the columns of such a file.
[[nodiscard]] bool is_runway_table(std::string_view text);
/// Throws UserError with file and row where a position or a glide path is not valid.
[[nodiscard]] SourceFeatures read_runway_file(const std::string& file);

/// Attributes of a layer of runways whose recipe states none: length and width, and the glide path if any runway states one.
[[nodiscard]] std::vector<AttributeRecipe> usual_attributes_of_runways(const SourceFeatures& runways);

}  // namespace tedavis::host_sim
