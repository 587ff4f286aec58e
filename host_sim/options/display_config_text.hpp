/// Writes the one configuration file of desk and board (platform/configuration/display_config.hpp).
#pragma once

#include <string>

#include "platform/configuration/display_config.hpp"

namespace tedavis::host_sim {

/// Returns TOML that reads back as the same configuration; it contains the file names as `config` states them.
[[nodiscard]] std::string display_config_text(const platform::DisplayConfig& config);

}  // namespace tedavis::host_sim
