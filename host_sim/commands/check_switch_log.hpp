/// `tedavis check` of a switch log.
#pragma once

#include <string>

#include "host_sim/commands/checked_file.hpp"

namespace tedavis::host_sim {

/// `panel`: file or shipped name of its switch config; empty: of the shipped ones the one that knows most of its lines. Throws
/// UserError where the file is no switch log or a line of it is broken.
[[nodiscard]] CheckedFile check_switch_log(const std::string& path, const std::string& panel);

}  // namespace tedavis::host_sim
