/// A terrain database in memory: what `terrain build` writes and `terrain check` recomputes.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/terrain_model.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// The whole file image. Equal models give equal bytes. Throws UserError when the terrain cannot be represented (a chunk
/// over capacity at level 0).
[[nodiscard]] std::vector<std::uint8_t> make_tdb(const TerrainModel& model, const BuildOptions& options);

}  // namespace tedavis::host_sim
