/// Oriented energy of a plane in four directions: the magnitude of a complex Gabor filter's response.
///
/// Waves of kGaborWave_px under a Gaussian of kGaborSigma_px, cut at kGaborRadius; the response to a constant plane is
/// subtracted (Morlet's form). A grating from 0 to 1 of that wavelength gives 1. Borders are repeated. Direction n is n times
/// 45 degrees: 0 stands for vertical stripes, whose normal points right, 1 for stripes whose normal points right and down.
///
/// Source: D. Gabor 1946; oriented pyramids of L. Itti, C. Koch, E. Niebur, IEEE PAMI 20 (1998).
#pragma once

#include <array>

#include "render_core/base/span.hpp"
#include "render_core/perception/plane.hpp"

namespace tedavis::perception {

inline constexpr int kDirections = 4, kGaborRadius = 4;
inline constexpr double kGaborWave_px = 4, kGaborSigma_px = 1.6;

/// Taps of one dimension, 0 to kGaborRadius; the other side is equal, for sines negated.
struct GaborTaps {
    using Taps = float[kGaborRadius + 1];
    Taps bell{};                           ///< the Gaussian, of sum 1
    Taps cosine{}, sine{};                 ///< along a wave's normal
    Taps slant_cosine{}, slant_sine{};     ///< along a row or column, for a diagonal wave
    float flat_share = 0, slant_flat = 0;  ///< responses to a constant 1, for axis-aligned and diagonal waves
};
[[nodiscard]] GaborTaps gabor_taps() noexcept;

/// Planes are filtered in strips whose rows stay in the first-level cache; scratch does not depend on their size.
inline constexpr int kGaborStrip = 128;
inline constexpr std::size_t kOrientedEnergyScratch =
    (5 * (2 * std::size_t{kGaborRadius} + 1) + 1) * (std::size_t{kGaborStrip} + 2 * kGaborRadius);
/// Computes the energy in all directions; `out` has planes of the same size.
void oriented_energy(const Plane& plane, const GaborTaps& taps, const std::array<Plane, kDirections>& out,
                     base::Span<float> scratch) noexcept;

}  // namespace tedavis::perception
