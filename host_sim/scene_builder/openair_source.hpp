/// Airspaces in the OpenAir format (WinPilot 1998, extended by Naviter 2.1): areas with class, floor and ceiling.
///
/// Fields: class (AC), type (AY), name (AN), floor and ceiling in metres with floor_datum and ceiling_datum: msl, ground or
/// standard (flight levels, above the 1013.25 hPa surface). Circles and arcs become polygons whose chords stay within a hundredth
/// of their radius. As files do not mark the end of an airspace, it ends at the next AC.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// True when the text looks like OpenAir: a line with AC before any other that is no comment.
[[nodiscard]] bool is_openair(std::string_view text);
/// Throws UserError with `name`, the line and what to do.
[[nodiscard]] SourceFeatures read_openair(std::string_view text, const std::string& name);

/// Attributes of a layer of airspaces whose recipe states none: floor and ceiling with their datums.
[[nodiscard]] std::vector<AttributeRecipe> usual_attributes_of_airspaces();

}  // namespace tedavis::host_sim
