/// Examines a file that can be a source of a scene, and writes a table [[layer]] for it.
#pragma once

#include <optional>
#include <string>

#include "host_sim/scene_builder/feature_look.hpp"
#include "host_sim/scene_builder/grid_look.hpp"
#include "host_sim/scene_builder/source_kind.hpp"

namespace tedavis::host_sim {

struct SourceLook {
    std::string file;
    SourceKind kind = SourceKind::grid;
    std::optional<GridLook> grid;         ///< of a raster
    std::optional<FeatureLook> features;  ///< of any other file
    std::string layer;                    ///< the table, as text
};

/// `crs`: the coordinate system of a file that states none; empty: not given. Throws UserError, one sentence, for a file that
/// cannot be a source.
[[nodiscard]] SourceLook look_at_source(const std::string& file, const std::string& crs);

/// "grid", "airspaces", "runways", "obstacles", "recorded flight", "table or map".
[[nodiscard]] std::string_view kind_text(SourceKind kind);

}  // namespace tedavis::host_sim
