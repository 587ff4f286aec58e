/// What goes into a pack: each file that a configuration names, and that configuration with names from the pack's folder.
#pragma once

#include <string>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/pack/packed_file.hpp"

namespace tedavis::host_sim {

struct PackContents {
    std::string title;
    std::string config_text;    ///< of the pack's config.toml
    std::string config_origin;  ///< the configuration that it was made of
    PackedFiles files;          ///< without config.toml
};

/// Reads each file as a start of the board does. Logs that the section [replay] names, and its instants, stay outside: what is
/// flown is given to each replay. `named` is what the configuration was read from. Throws UserError: what is missing or wrong in
/// which file.
[[nodiscard]] PackContents pack_contents(const ReplayOptions& options, const std::string& named);

}  // namespace tedavis::host_sim
