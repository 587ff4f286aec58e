/// Noise over the grid that stands for relief finer than the posts: the same at the same place for ever, on every machine.
///
/// Octaves of value noise (lattice values, faded between) or gradient noise (Perlin 1985, 2002: lattice slopes, quintic fade),
/// each of twice the frequency and `gain` times the height of the one before. Lattice values come from an integer hash of the
/// place, no table: any place of any grid, neighbouring grids without a seam where their origins differ by whole posts.
///
/// Bounds that hold bit for bit: |height| <= amplitude, which is what all octaves share. Pure; any thread; 4 hashes an octave.
#pragma once

#include <cstdint>

#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

enum class NoiseKind : std::uint8_t { value, gradient };

struct MicroNoise {
    static constexpr std::uint32_t kMaxOctaves = 8;

    NoiseKind kind = NoiseKind::gradient;
    std::uint32_t octaves = 3;  ///< 1..kMaxOctaves
    std::uint32_t seed = 1;
    double amplitude = 1;                          ///< height steps, 0 or more
    double frequency = 1;                          ///< lattice points a post, of the first octave; above 0
    double gain = 0.5;                             ///< 0..1
    std::int64_t first_column = 0, first_row = 0;  ///< of the grid, among grids that lie side by side
};

/// x and y in grid space.
[[nodiscard]] SurfacePoint noise_at(const MicroNoise& noise, double x, double y);

/// No slope of the noise is steeper than this, along x or along y, in height steps a post.
[[nodiscard]] double steepest_slope(const MicroNoise& noise);

/// -1..1 (1 left out) of a lattice point: every bit of the three changes every bit of it with probability one half.
[[nodiscard]] double lattice_value(std::int64_t column, std::int64_t row, std::uint32_t seed);

}  // namespace tedavis::raytrace
