/// A table [[layer]] with which a scene file can begin to use a source: the scene builder accepts it as it is.
#pragma once

#include <string>

#include "host_sim/scene_builder/feature_look.hpp"
#include "host_sim/scene_builder/grid_look.hpp"
#include "host_sim/scene_builder/source_kind.hpp"

namespace tedavis::host_sim {

/// `file` becomes an absolute name, so that the table holds in any folder. `crs` as it was given for a file that states none.
[[nodiscard]] std::string grid_block(const std::string& file, const std::string& crs, const GridLook& look);
[[nodiscard]] std::string feature_block(const std::string& file, const std::string& crs, SourceKind kind,
                                        const FeatureLook& look);

/// Small letters, digits and underscores, at most `longest` bytes, as names in scene files are usual.
[[nodiscard]] std::string plain_name(const std::string& text, std::size_t longest);

}  // namespace tedavis::host_sim
