/// Generated terrain of any size: a fractional Brownian surface by midpoint displacement on a square lattice (Fournier,
/// Fussell, Carpenter, "Computer Rendering of Stochastic Models", CACM 25(6), 1982; the diamond-square form).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tedavis::host_sim {

inline constexpr std::uint32_t kFewestFractalPosts = 3, kMostFractalPosts = 16385;
/// The raster's north-west post and its step: a place in the Alps, one second of arc.
inline constexpr double kFractalWest_deg = 10.0, kFractalNorth_deg = 47.0, kFractalStep_deg = 1.0 / 3600;

/// A square of posts, row 0 in the north, heights in metres from 0 up, at most 4000.
struct FractalTerrain {
    std::uint32_t posts = 0;  ///< a side
    std::vector<float> height_m;

    [[nodiscard]] float at(std::uint32_t i, std::uint32_t j) const { return height_m[std::size_t{j} * posts + i]; }
};

/// Called with work done and total; may throw to stop.
using FractalProgress = std::function<void(std::uint64_t, std::uint64_t)>;

/// `posts` a side, kFewestFractalPosts..kMostFractalPosts. Equal arguments give equal bits on every machine.
[[nodiscard]] FractalTerrain make_fractal_terrain(std::uint32_t posts, std::uint64_t seed, const FractalProgress& progress = {});

/// The bytes of a GeoTIFF (Float32, EPSG:4326) of the terrain. Throws UserError where the memory does not suffice.
[[nodiscard]] std::string fractal_geotiff(const FractalTerrain& terrain);

}  // namespace tedavis::host_sim
