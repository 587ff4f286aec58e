/// The configuration of a replay (`--save-config`, `--config`): the one file of desk and board
/// (platform/configuration/display_config.hpp), with a section of the desk:
///
///     [replay]
///     log = "flight.log"             files are found from the folder of the file
///     switches = "flight.switches"   what the panel of [switches] did
///     phase = "cruise"               as if a switch stated it, or "none"
///     class = "jet"                  by which motion tells the phase
///     from_s, to_s, step_s, spread, over_terrain, frames, gl, ghosts, ghost_align
///     show_accuracy, error_map, force_effects, saliency, clutter
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"

namespace tedavis::host_sim {

/// TOML with every option that decides what the frames show; paths as absolute ones, so that the file can be moved. The
/// output folder, the window and its tour are not part of it. What the board alone has is that of the configuration that the
/// options come from. Throws UserError for a config name that nothing stands behind.
[[nodiscard]] std::string replay_config_text(const ReplayOptions& options);
/// The section [replay] alone; empty where it would say nothing.
[[nodiscard]] std::string replay_section_text(const ReplayOptions& options);
/// Writes the text to a file, whole or not at all.
void save_replay_config(const ReplayOptions& options, const std::string& path);
/// `path` may be a pack, which must be as its manifest says, and signed with the key of the file `pack_key` where there is one.
/// Throws UserError with file and line.
[[nodiscard]] ReplayOptions load_replay_config(const std::string& path,
                                               const std::string& pack_key = platform::kInstalledPackKey);

}  // namespace tedavis::host_sim
