/// Where the eye goes first, second and so on: the maxima of a saliency map, each of which inhibits a disc round it (winner take
/// all, inhibition of return).
///
/// The model's neurons and their times are left out: the winner is the largest value, of equal ones the uppermost, of these the
/// leftmost. The source's focus of attention is a disc with a sixth of the picture's smaller side as its radius, and so is what
/// it inhibits; no more than a dozen or two of them have room in a picture.
///
/// Pure, no memory. Bounded: every place looks at the whole map once.
///
/// Source: L. Itti, C. Koch, E. Niebur, "A Model of Saliency-Based Visual Attention for Rapid Scene Analysis", IEEE PAMI 20
/// (1998), section 3.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/perception/saliency_model.hpp"

namespace tedavis::perception {

inline constexpr std::size_t kMaxSalientPlaces = 32;
inline constexpr double kFocusShare = 1.0 / 6;  ///< radius of the focus of attention, of the picture's smaller side

/// Middle of a pixel of the map, in pixels of the picture.
struct SalientPlace {
    double x = 0, y = 0;
    float value = 0;  ///< 0..1, greater than 0
};
using SalientPlaces = base::FixedVector<SalientPlace, kMaxSalientPlaces>;

/// A byte a pixel of the map, rows from the top: 0 where no place is to be. Empty: everywhere may be one.
using PlaceMask = base::Span<const std::uint8_t>;

/// The first `most` places, fewer where nothing salient is left; radius in pixels of the picture, at least 0. None where the
/// mask is shorter than the map.
[[nodiscard]] SalientPlaces salient_places(const SaliencyMap& map, double radius_px, std::size_t most,
                                           PlaceMask mask = {}) noexcept;

}  // namespace tedavis::perception
