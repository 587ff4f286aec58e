/// `tedavis terrain build | check | info | fractal`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct TerrainBuildOptions {
    std::vector<std::string> rasters;
    std::string output;
    std::string crs;             ///< empty: the files' own
    std::string extent;          ///< "W,S,E,N" in units of crs, of a file that has no place; empty: none
    std::string bounds;          ///< "W,S,E,N" in degrees; empty: all
    std::string vertical_datum;  ///< "egm96" or "ellipsoid"; empty: the files' own, else egm96
    std::string encoding;        ///< "terrain-rgb" or "terrarium", of colour pictures; empty: none
    std::optional<double> void_value;
    std::optional<double> accuracy_m;  ///< LE90 of the source; none or 0: unknown, in a check: as the database states
    std::string drape;                 ///< image over the terrain; empty: none
    std::string drape_crs;             ///< empty: the image's own
    std::string drape_extent;          ///< "W,S,E,N" in units of drape_crs, of an image that has no place; empty: none
};

struct TerrainCheckOptions {
    std::string database;
    TerrainBuildOptions build;  ///< the rasters and options it was built with
};

struct TerrainInfoOptions {
    std::string database;
};

struct TerrainFractalOptions {
    std::uint32_t size = 1025;  ///< posts a side
    std::uint64_t seed = 1;
    std::string output;
    std::string numbers = "float32";  ///< or "int16"
};

/// Returns all that a build depends on besides the program, as a text: names, sizes and times of the files, and options. Equal
/// texts give equal databases.
[[nodiscard]] std::string terrain_build_identity(const TerrainBuildOptions& options);

/// Each returns the exit code and throws UserError for bad input.
[[nodiscard]] int run_terrain_build(const TerrainBuildOptions& options, Console& console);
[[nodiscard]] int run_terrain_check(const TerrainCheckOptions& options, Console& console);
[[nodiscard]] int run_terrain_info(const TerrainInfoOptions& options, Console& console);
[[nodiscard]] int run_terrain_fractal(const TerrainFractalOptions& options, Console& console);

}  // namespace tedavis::host_sim
