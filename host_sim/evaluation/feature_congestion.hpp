/// Feature Congestion, a second measure of clutter: how much of the feature space of colours, contrasts and directions is
/// occupied round each pixel, so that a new object would have to be stronger to be noticed. 0 for a uniform picture; there is
/// no upper limit.
///
/// Source: R. Rosenholtz, Y. Li, L. Nakano, "Measuring visual clutter", Journal of Vision 7(2):17 (2007). At three sizes of the
/// picture each feature's covariance under a Gaussian window gives an ellipsoid, whose mean radius (a root of its volume) is
/// the clutter; the greatest of the sizes counts, and the three features add up, each divided by its usual value. README.md of
/// this folder states the choices that the paper leaves open.
#pragma once

#include "host_sim/evaluation/evaluation_views.hpp"
#include "host_sim/evaluation/lab_levels.hpp"

namespace tedavis::host_sim {

/// The congestion that views draw white.
inline constexpr float kFullCongestion = 24;

struct FeatureCongestion {
    double mean = 0;  ///< over all pixels
    FloatMap map;     ///< of the picture's size, not cut at 1; its mean is `mean` to a float's accuracy
};

[[nodiscard]] FeatureCongestion feature_congestion(const LabLevels& picture);

}  // namespace tedavis::host_sim
