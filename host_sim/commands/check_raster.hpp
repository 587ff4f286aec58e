/// `tedavis check` of a height raster.
#pragma once

#include <string>

#include "host_sim/commands/checked_file.hpp"

namespace tedavis::host_sim {

/// Reads every post, as the terrain builder does. Throws UserError where it is not a height raster or has no heights.
[[nodiscard]] CheckedFile check_raster(const std::string& path);

}  // namespace tedavis::host_sim
