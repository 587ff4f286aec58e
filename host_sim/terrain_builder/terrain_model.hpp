/// A raster made ready for chunks: padded lattice, nested errors, tolerances and levels. Building a database and checking
/// one both start here.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/terrain_builder/mesh_levels.hpp"
#include "host_sim/terrain_builder/raster.hpp"

namespace tedavis::host_sim {

struct BuildOptions {
    double le90_m = 0;
    VerticalDatum vertical_datum = VerticalDatum::egm96;
    /// Called with work done and total; may throw to stop.
    std::function<void(std::uint64_t, std::uint64_t)> progress;
};

/// Everything a chunk is made from.
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

/// Place of a post of the lattice, also beyond the raster's last one.
[[nodiscard]] inline double post_longitude_deg(const Raster& raster, std::int64_t i) {
    return raster.west_deg + raster.step_lon_deg * static_cast<double>(i);
}
[[nodiscard]] inline double post_latitude_deg(const Raster& raster, std::int64_t j) {
    return std::max(-90.0, raster.north_deg - raster.step_lat_deg * static_cast<double>(j));
}

/// Levels are added while every chunk stays within the format's capacities; tolerances grow with the level.
[[nodiscard]] TerrainModel make_model(Raster raster, const BuildOptions& options);

}  // namespace tedavis::host_sim
