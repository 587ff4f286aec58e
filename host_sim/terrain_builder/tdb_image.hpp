/// A terrain database in memory, from a raster: what `terrain build` writes and `terrain check` recomputes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/mesh_levels.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

struct BuildOptions {
    double le90_m = 0;
    VerticalDatum vertical_datum = VerticalDatum::egm96;
    /// Called with work done and total; may throw to stop.
    std::function<void(std::uint64_t, std::uint64_t)> progress;
};

/// Everything a chunk is made from; shared by building and checking.
struct TerrainModel {
    Raster raster;
    Lattice lattice;
    std::vector<float> errors_m;
    std::vector<std::uint8_t> levels;
    std::array<float, 16> tolerance_m{};
    double undulation_west_deg = 0, undulation_north_deg = 0;
    std::uint32_t undulation_columns = 0, undulation_rows = 0;
    std::vector<float> undulation_m;  ///< 0.25 degree nodes, row 0 in the north
};

inline constexpr double kUndulationStep_deg = 0.25;

/// Levels are added while every chunk stays within the format's capacities; tolerances grow with the level.
[[nodiscard]] TerrainModel make_model(Raster raster, const BuildOptions& options);

/// The whole file image. Throws UserError when the terrain cannot be represented (a chunk over capacity at level 0).
[[nodiscard]] std::vector<std::uint8_t> make_tdb(const TerrainModel& model, const BuildOptions& options);

}  // namespace tedavis::host_sim
