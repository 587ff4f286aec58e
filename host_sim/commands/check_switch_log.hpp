/// `tedavis check` of a switch log.
#pragma once

#include <string>

#include "host_sim/commands/checked_file.hpp"

namespace tedavis::host_sim {

/// `panel` is the file or shipped name of its switch config; empty: the shipped one that knows most of its lines. Throws
/// UserError where the file is not a switch log or a line is malformed.
[[nodiscard]] CheckedFile check_switch_log(const std::string& path, const std::string& panel);

}  // namespace tedavis::host_sim
