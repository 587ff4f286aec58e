/// Combines feature maps to a saliency map; each map is weighted by how rare and how strong its features are (thesis, 5.3.3,
/// after Han and Zhou 2007).
///
///     H(M) = -log2 p(M)            p(M): share of the map's pixels that show the feature, by Laplace's estimate (entropy.hpp)
///     w(M) = H(M) max M            of a feature map; H(M) alone of a conspicuity map
///     I, C, O = sum of w(M) M      over the signs of lightness, those of both colours, and the four directions
///     S = w(I) I + w(C) C + w(O) O
///
/// per_picture (the thesis's)  a pixel shows a feature above half of the map's maximum; S is divided by its maximum. The most
///     salient place of a picture has 1, however faint it is.
/// fixed  a pixel shows a feature above kNoticeable; w(M) = H(M) / log2(N + 2) with N pixels, without the amplitude, and 0 where
///     none shows it; conspicuity maps count alike; S is multiplied by kFixedGain, and more than 1 is cut. What a place has
///     depends on others only by how many show the same, so that frames can be compared: a lone white disk on black has 1, a
///     cockpit picture 0.15 to 0.4 at its most salient place.
///
/// A feature map whose maximum is below kMinAmplitude is rounding noise and has weight 0. Where all weights are 0, nothing is
/// salient: S is 0 everywhere.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/perception/plane.hpp"

namespace tedavis::perception {

enum class SaliencyScale : std::uint8_t { per_picture, fixed };

inline constexpr float kNoticeable = 0.023f;  ///< 2.3 units of L*a*b*, a just noticeable difference (Mahy et al. 1994)
inline constexpr float kFixedGain = 2;
inline constexpr float kMinAmplitude = 1e-4f;

inline constexpr int kFeatureMaps = 10;
inline constexpr std::array<int, 4> kFirstOfConspicuity = {0, 2, 6, kFeatureMaps};  ///< lightness +-, a +-, b +-, directions

/// w(M) of a conspicuity map.
[[nodiscard]] double conspicuity_weight(const Plane& map, SaliencyScale scale) noexcept;
/// w(M) of a feature map.
[[nodiscard]] double feature_weight(const Plane& map, SaliencyScale scale) noexcept;

struct SaliencyMaps {
    std::array<Plane, kFeatureMaps> features;
    Plane conspicuity;  ///< scratch of the same size
    Plane saliency;     ///< the result, 0..1
};
/// Computes the saliency; returns false where nothing is salient.
[[nodiscard]] bool combine(const SaliencyMaps& maps, SaliencyScale scale) noexcept;

}  // namespace tedavis::perception
