/// The text of a switch log; throws UserError where the file cannot be read or does not begin as one.
#pragma once

#include <string>

namespace tedavis::host_sim {

[[nodiscard]] std::string read_switch_log(const std::string& path);

}  // namespace tedavis::host_sim
