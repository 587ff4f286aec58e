/// Centre-surround differences: differences between finer and coarser levels of a feature's pyramid, added across scales
/// (thesis, 5.3.3; Itti, Koch, Niebur 1998: centres two to four levels below the picture, surrounds three and four levels
/// coarser).
///
/// The result is the mean over the kCenters x kSurrounds pairs, at the size of the finest centre.
#pragma once

#include <array>

#include "render_core/base/span.hpp"
#include "render_core/perception/plane.hpp"
#include "render_core/perception/pyramid.hpp"

namespace tedavis::perception {

inline constexpr int kCenters = 3, kSurrounds = 2, kNearestSurround = 3;
inline constexpr int kFeatureLevels = kCenters - 1 + kNearestSurround + kSurrounds;  // 7

/// Levels of a feature from the finest centre on, each half as large as the one before, rounded up.
using FeaturePyramid = std::array<Plane, kFeatureLevels>;
/// Planes of the size of the centres.
using CenterPlanes = std::array<Plane, kCenters>;

/// Elements of scratch for a width of the finest centre.
[[nodiscard]] constexpr std::size_t center_surround_scratch(int width) { return kSurrounds * expansion_scratch(width); }

/// Computes separately where the feature exceeds its surroundings and where it falls below them; the results are the finest
/// planes.
void signed_differences(const FeaturePyramid& feature, const CenterPlanes& above, const CenterPlanes& below,
                        base::Span<float> scratch) noexcept;
/// Computes the absolute differences; the result is the finest plane.
void differences(const FeaturePyramid& feature, const CenterPlanes& out, base::Span<float> scratch) noexcept;

}  // namespace tedavis::perception
