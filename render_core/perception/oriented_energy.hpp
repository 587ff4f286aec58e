/// How strongly a plane is striped in four directions: the length of a complex Gabor filter's answer.
///
/// Waves of kGaborWave_px under a Gaussian of kGaborSigma_px, cut at kGaborRadius; what the filter answers to a plane without
/// structure is taken away (Morlet's form). 1 is a grating from 0 to 1 of that wave. Borders repeated. Direction n is n times 45
/// degrees: 0 has stripes that stand upright, whose normal points right, 1 those whose normal points right and down.
///
/// Source: D. Gabor 1946; oriented pyramids of L. Itti, C. Koch, E. Niebur, IEEE PAMI 20 (1998).
#pragma once

#include <array>

#include "render_core/base/span.hpp"
#include "render_core/perception/plane.hpp"

namespace tedavis::perception {

inline constexpr int kDirections = 4, kGaborRadius = 4;
inline constexpr double kGaborWave_px = 4, kGaborSigma_px = 1.6;

/// Taps of one dimension, 0 to kGaborRadius; the other side is the same, of sines the opposite.
struct GaborTaps {
    using Taps = float[kGaborRadius + 1];
    Taps bell{};                           ///< the Gaussian, of sum 1
    Taps cosine{}, sine{};                 ///< along a wave's normal
    Taps slant_cosine{}, slant_sine{};     ///< along a side, of a wave that lies diagonally
    float flat_share = 0, slant_flat = 0;  ///< answers to 1 everywhere, along a side and diagonally
};
[[nodiscard]] GaborTaps gabor_taps() noexcept;

/// Elements of scratch, for planes of any size: they are filtered in strips, whose rows stay in the first cache.
inline constexpr int kGaborStrip = 128;
inline constexpr std::size_t kOrientedEnergyScratch =
    (5 * (2 * std::size_t{kGaborRadius} + 1) + 1) * (std::size_t{kGaborStrip} + 2 * kGaborRadius);
/// `out` has planes of the same size.
void oriented_energy(const Plane& plane, const GaborTaps& taps, const std::array<Plane, kDirections>& out,
                     base::Span<float> scratch) noexcept;

}  // namespace tedavis::perception
