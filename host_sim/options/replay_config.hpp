/// One file that names data, design and parameters of a replay (`--save-config`, `--config`).
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"

namespace tedavis::host_sim {

/// TOML with every option that decides what the frames show; paths as absolute ones, so that the file can be moved. The
/// output folder, the window and its tour are not part of it. Throws UserError for a config name that nothing stands behind.
[[nodiscard]] std::string replay_config_text(const ReplayOptions& options);
/// Writes the text to a file, whole or not at all.
void save_replay_config(const ReplayOptions& options, const std::string& path);
/// Throws UserError with file and line.
[[nodiscard]] ReplayOptions load_replay_config(const std::string& path);

}  // namespace tedavis::host_sim
