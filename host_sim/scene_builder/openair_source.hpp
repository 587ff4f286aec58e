/// Airspaces in the OpenAir format (WinPilot 1998, extended by Naviter 2.1): areas with class, floor and ceiling.
///
/// Fields: class (AC), type (AY), name (AN), floor and ceiling in metres with floor_datum and ceiling_datum: msl, ground or
/// standard (flight levels, above the 1013.25 hPa surface). Circles and arcs become polygons whose chords stay within a hundredth
/// of their radius. Files underspecify: an airspace ends where the next AC begins.
#pragma once

#include <string>
#include <string_view>

#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// True when the text looks like OpenAir: a line with AC before any other that is no comment.
[[nodiscard]] bool is_openair(std::string_view text);
/// Throws UserError with `name`, the line and what to do.
[[nodiscard]] SourceFeatures read_openair(std::string_view text, const std::string& name);

}  // namespace tedavis::host_sim
