/// `tedavis check` of a candump log, which may be gzip-compressed.
#pragma once

#include <string>

#include "host_sim/commands/checked_file.hpp"

namespace tedavis::host_sim {

/// `bus`: file or shipped name, by which its frames are read. Throws UserError where no line of it is a frame.
[[nodiscard]] CheckedFile check_log(const std::string& path, const std::string& bus);

}  // namespace tedavis::host_sim
