/// `tedavis check` of a height raster.
#pragma once

#include <string>

#include "host_sim/commands/checked_file.hpp"

namespace tedavis::host_sim {

/// Read to its last post, as the terrain builder does. Throws UserError where it is no height raster or has no height at all.
[[nodiscard]] CheckedFile check_raster(const std::string& path);

}  // namespace tedavis::host_sim
