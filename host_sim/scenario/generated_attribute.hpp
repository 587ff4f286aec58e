/// Attributes of the layers that a scenario generates.
#pragma once

#include <string>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// What every generated layer says of its source.
inline constexpr const char* kGeneratedOrigin = "generated for demonstrations; not for navigation";

/// Without values, by point. `full_sigma`: the standard deviation that counts as 1, in the unit; 0: it states none.
[[nodiscard]] AttributeDraft generated_attribute(const std::string& name, const std::string& title, const std::string& unit,
                                                 double full_sigma);
/// A value with its standard deviation; of attributes that state one.
void add_value(AttributeDraft& attribute, double value, double sigma);

}  // namespace tedavis::host_sim
