/// Writes a table [[layer]] for a source, as a start for a scene file: the scene builder accepts it without changes.
#pragma once

#include <string>

#include "host_sim/scene_builder/feature_look.hpp"
#include "host_sim/scene_builder/grid_look.hpp"
#include "host_sim/scene_builder/source_kind.hpp"

namespace tedavis::host_sim {

/// `file` is written as an absolute path, so that the table is valid in any folder. `crs` is the coordinate system given for a
/// file that states none.
[[nodiscard]] std::string grid_block(const std::string& file, const std::string& crs, const GridLook& look);
[[nodiscard]] std::string feature_block(const std::string& file, const std::string& crs, SourceKind kind,
                                        const FeatureLook& look);

/// Converts a text to lower-case letters, digits and underscores, at most `longest` bytes, as is usual for names in scene files.
[[nodiscard]] std::string plain_name(const std::string& text, std::size_t longest);

}  // namespace tedavis::host_sim
