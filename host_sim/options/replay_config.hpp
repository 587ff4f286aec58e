/// The configuration file of a replay (`--save-config`, `--config`). It is the file that a board reads, too
/// (platform/configuration/display_config.hpp), with a further section that only the desk reads:
///
///     [replay]
///     log = "flight.log"             files are found from the folder of the file
///     switches = "flight.switches"   log of the edges of the panel in [switches]
///     phase = "cruise"               stated for the whole run, or "none"
///     class = "jet"                  for the detection of the phase from motion
///     from_s, to_s, step_s, spread, over_terrain, frames, gl, ghosts, ghost_align
///     show_accuracy, error_map, force_effects, saliency, clutter
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"

namespace tedavis::host_sim {

/// Returns TOML with every option that decides what the frames show. Paths are written as absolute ones, so that the file can be
/// moved. The output folder, the window and its tour are not written. Keys that only a board reads are copied from the
/// configuration that the options were read from. Throws UserError where a short name has no shipped file, or a value is too long
/// for a configuration.
[[nodiscard]] std::string replay_config_text(const ReplayOptions& options);
/// Returns the section [replay] alone; empty where all its options have their defaults.
[[nodiscard]] std::string replay_section_text(const ReplayOptions& options);
/// Writes replay_config_text() to a file, whole or not at all. Throws UserError.
void save_replay_config(const ReplayOptions& options, const std::string& path);
/// Reads a configuration file or a pack. A pack must match its manifest and, where the file `pack_key` exists, be signed with the
/// key in it. Throws UserError with file and line.
[[nodiscard]] ReplayOptions load_replay_config(const std::string& path,
                                               const std::string& pack_key = platform::kInstalledPackKey);

}  // namespace tedavis::host_sim
