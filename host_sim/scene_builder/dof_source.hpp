/// The Digital Obstacle File of the FAA (`*.Dat`: lines of fixed columns, "DOF README" of the Aeronautical Information Services).
///
/// Each obstacle is a point with the height above ground that the file states. Fields: name (the kind), ident, kind, city,
/// country, state, quantity, height_m (above ground), top_m (above mean sea level), lighting and marking (the file's letters),
/// status ("verified" or "unverified"), and the tolerances that the accuracy codes mean, horizontal_m and vertical_m; absent
/// where the code is "unknown". Dismantled obstacles, which files of changes list, are left out and noted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// True if the text begins with a date line or a record.
[[nodiscard]] bool is_dof(std::string_view text);
/// Throws UserError with `name`, the line and what to do.
[[nodiscard]] SourceFeatures read_dof(std::string_view text, const std::string& name);

/// Attributes of a layer whose recipe states none: the height with its tolerance, and the tolerance of the position.
[[nodiscard]] std::vector<AttributeRecipe> usual_attributes_of_dof();

}  // namespace tedavis::host_sim
