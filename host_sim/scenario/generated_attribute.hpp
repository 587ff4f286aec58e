/// Attributes of the layers that a scenario generates.
#pragma once

#include <string>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// The source that every generated layer states.
inline constexpr const char* kGeneratedOrigin = "generated for demonstrations; not for navigation";

/// Returns an attribute of points without values. `full_sigma` is the standard deviation with level 1, in the unit; 0: no
/// uncertainty.
[[nodiscard]] AttributeDraft generated_attribute(const std::string& name, const std::string& title, const std::string& unit,
                                                 double full_sigma);
/// Adds a value with its standard deviation, for attributes with uncertainty.
void add_value(AttributeDraft& attribute, double value, double sigma);

}  // namespace tedavis::host_sim
