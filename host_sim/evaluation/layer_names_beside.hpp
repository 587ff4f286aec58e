/// The names of the layers of a picture that no replay wrote (layer_mask.hpp).
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

/// From `P.json` or `sheet.json` beside the picture `P.png`; empty where it has no layer mask or neither record is there.
[[nodiscard]] std::vector<std::string> layer_names_beside(const std::string& picture);

}  // namespace tedavis::host_sim
