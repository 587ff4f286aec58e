/// `tedavis check` of a candump log, which may be gzip-compressed.
#pragma once

#include <string>

#include "host_sim/commands/checked_file.hpp"

namespace tedavis::host_sim {

/// `bus` is the file or shipped name of the bus layout. Throws UserError where no line is a frame.
[[nodiscard]] CheckedFile check_log(const std::string& path, const std::string& bus);

}  // namespace tedavis::host_sim
