/// Generated terrain without borders: a fractional Brownian surface with ridges, as a sum of gradient noise octaves.
///
/// Each octave is gradient noise on a square lattice (Perlin, "Improving Noise", SIGGRAPH 2002) whose amplitude is proportional
/// to its wavelength; the coarse ones are folded to ridges (Musgrave in Ebert et al., "Texturing and Modeling", 3rd ed., 2003,
/// chapter 16). Lattice nodes get their gradients from a counter-based hash of seed, octave and place (Salmon et al., "Parallel
/// Random Numbers: As Easy as 1, 2, 3", SC 2011; the mixing function is that of Steele, Lea and Flood, "Fast Splittable
/// Pseudorandom Number Generators", OOPSLA 2014). Lattices of successive octaves are rotated against each other by angles with
/// rational sines and cosines, so that their nodes do not coincide and every place is exact in integers.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/span.hpp"

namespace tedavis::host_sim {

/// Heights in metres, 0 to 4000; lower heights are sea and exactly 0. Posts are about 30 m apart. The height at a place depends
/// only on the seed and the place: equal bits from every window, on every machine.
class FractalTerrain {
public:
    explicit FractalTerrain(std::uint64_t seed);

    /// Writes the posts i..i+columns-1, j..j+rows-1, row by row, to `heights_m`, which has columns times rows elements. Any
    /// thread.
    void read(std::int32_t i, std::int32_t j, std::uint32_t columns, std::uint32_t rows, base::Span<float> heights_m) const;

private:
    struct Octave {
        std::int64_t cosine, sine, side;  ///< of the turned lattice: a step along a row, and a cell, in units of the hypotenuse
        std::int64_t offset_u, offset_v;
        std::uint64_t key;
        float amplitude_m;
        bool ridged;
    };
    static constexpr int kOctaves = 11;

    void add_octave(const Octave& octave, std::int32_t i, std::int32_t j, base::Span<float> row) const;

    std::array<Octave, kOctaves> octaves_;
};

}  // namespace tedavis::host_sim
