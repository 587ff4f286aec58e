/// The layer names of a picture that a command other than `replay` wrote, such as `shot` or `sheet` (layer_mask.hpp).
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

/// Reads the names from `P.json` or `sheet.json` beside the picture `P.png`; empty without a layer mask or a record.
[[nodiscard]] std::vector<std::string> layer_names_beside(const std::string& picture);

}  // namespace tedavis::host_sim
