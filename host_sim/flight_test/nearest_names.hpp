/// Names that a misspelt one may stand for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tedavis::host_sim {

/// Edits (a letter inserted, removed or replaced) that lead from one text to the other.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);
/// Up to three of the names, the nearest first: "a, b or c"; empty where there are no names. A name may also be near by one of
/// the words that it is made of.
[[nodiscard]] std::string nearest_names(std::string_view name, const std::vector<std::string>& names);

}  // namespace tedavis::host_sim
