/// Names that are similar to a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tedavis::host_sim {

/// The Levenshtein distance: the least number of letters to insert, remove or replace.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);
/// Up to three of the names, the nearest first: "a, b or c"; empty where there are no names. A name is also near if one of its
/// words is.
[[nodiscard]] std::string nearest_names(std::string_view name, const std::vector<std::string>& names);

}  // namespace tedavis::host_sim
