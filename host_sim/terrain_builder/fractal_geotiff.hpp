/// Writes generated terrain as a GeoTIFF, tile by tile, so that the memory does not depend on its size.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace tedavis::host_sim {

inline constexpr std::uint32_t kFewestFractalPosts = 3, kMaxFractalPosts = (1u << 17) + 1;
/// The raster's north-west post and its step: a place in the Alps, one second of arc.
inline constexpr double kFractalWest_deg = 10.0, kFractalNorth_deg = 47.0, kFractalStep_deg = 1.0 / 3600;

enum class FractalNumbers { float32, int16 };  ///< int16: rounded to whole metres

/// Called with work done and all; may throw to stop.
using FractalProgress = std::function<void(std::uint64_t, std::uint64_t)>;

/// Writes a square of `posts` a side (kFewestFractalPosts..kMaxFractalPosts) of FractalTerrain in tiles of 256 by 256 posts,
/// EPSG:4326, as BigTIFF where it needs one. The file appears complete or not at all (see AtomicFile). Equal arguments give equal
/// posts on every machine. Throws UserError where the folder cannot be written.
void write_fractal_geotiff(const std::string& path, std::uint32_t posts, std::uint64_t seed, FractalNumbers numbers,
                           const FractalProgress& progress = {});

}  // namespace tedavis::host_sim
