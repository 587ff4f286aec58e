/// Noise over the grid for relief finer than the posts; it depends only on the position and is equal on every machine.
///
/// Octaves of value noise (lattice values, faded between) or gradient noise (Perlin 1985, 2002: lattice slopes, quintic fade),
/// each of twice the frequency and `gain` times the height of the one before. Lattice values come from an integer hash of the
/// position, without a table, so neighbouring grids whose origins differ by whole posts join without a seam.
///
/// |height| <= amplitude holds bit for bit for the sum of all octaves. Pure; any thread; 4 hashes per octave.
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
    double frequency = 1;                          ///< lattice points per post in the first octave; above 0
    double gain = 0.5;                             ///< 0..1
    std::int64_t first_column = 0, first_row = 0;  ///< origin of the grid among neighbouring grids
};

/// Returns the noise at x and y of grid space.
[[nodiscard]] SurfacePoint noise_at(const MicroNoise& noise, double x, double y);

/// Upper bound of the noise's slopes along x or y, in height steps per post.
[[nodiscard]] double steepest_slope(const MicroNoise& noise);

/// Returns the value in [-1, 1) of a lattice point; each bit of the arguments changes each bit of the hash with probability one
/// half.
[[nodiscard]] double lattice_value(std::int64_t column, std::int64_t row, std::uint32_t seed);

}  // namespace tedavis::raytrace
