/// The contents of a pack: each file that a configuration names, and the configuration with names relative to the pack's folder.
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/pack/packed_file.hpp"

namespace tedavis::host_sim {

struct PackContents {
    std::string title;
    std::string config_text;    ///< of the pack's config.toml
    std::string config_origin;  ///< the configuration from which the pack is made
    PackedFiles files;          ///< without config.toml
};

/// Reads each file as the board does at its start. Logs and times of the section [replay] are left out, since each replay of the
/// pack states its own. `named` is the path from which the configuration was read. Throws UserError with the file that is missing
/// or wrong.
[[nodiscard]] PackContents pack_contents(const ReplayOptions& options, const std::string& named);

}  // namespace tedavis::host_sim
