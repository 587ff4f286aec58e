/// The predicted sequence of fixations: maxima of a saliency map, each of which inhibits a disc round it (winner-take-all,
/// inhibition of return).
///
/// Neural dynamics are not modelled: the winner is the largest value; of equal ones the uppermost, then the leftmost. In the
/// source, the focus of attention and the inhibited area are discs whose radius is a sixth of the picture's smaller side; no
/// more than a dozen or two of them fit in a picture.
///
/// Pure, no memory. Bounded: the whole map is read once per place.
///
/// Source: L. Itti, C. Koch, E. Niebur, "A Model of Saliency-Based Visual Attention for Rapid Scene Analysis", IEEE PAMI 20
/// (1998), section 3.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/perception/saliency_model.hpp"

namespace tedavis::perception {

inline constexpr std::size_t kMaxSalientPlaces = 32;
inline constexpr double kFocusShare = 1.0 / 6;  ///< radius of the focus of attention as a share of the picture's smaller side

/// A place: the centre of a map pixel, in pixels of the picture.
struct SalientPlace {
    double x = 0, y = 0;
    float value = 0;  ///< 0..1, greater than 0
};
using SalientPlaces = base::FixedVector<SalientPlace, kMaxSalientPlaces>;

/// One byte per pixel of the map, rows from the top: 0 where no place is allowed. Empty: all are allowed.
using PlaceMask = base::Span<const std::uint8_t>;

/// Returns the first `most` places, fewer where nothing salient is left. `radius_px` is in pixels of the picture, at least 0.
/// Returns none where the mask is shorter than the map.
[[nodiscard]] SalientPlaces salient_places(const SaliencyMap& map, double radius_px, std::size_t most,
                                           PlaceMask mask = {}) noexcept;

}  // namespace tedavis::perception
