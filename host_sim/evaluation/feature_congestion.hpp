/// Feature Congestion, a second measure of clutter: how much of the feature space of colours, contrasts and directions is
/// occupied around each pixel; the more, the stronger a new object must be to be noticed. 0 for a uniform picture; there is no
/// upper limit.
///
/// Source: R. Rosenholtz, Y. Li, L. Nakano, "Measuring visual clutter", Journal of Vision 7(2):17 (2007). At three scales of the
/// picture, the covariance of each feature under a Gaussian window is an ellipsoid, whose mean radius (a root of its volume) is
/// the clutter. The maximum over the scales is used, and the three features are added, each divided by its usual value. README.md
/// of this folder states the choices that the paper leaves open.
#pragma once

#include "host_sim/evaluation/evaluation_views.hpp"
#include "host_sim/evaluation/lab_levels.hpp"

namespace tedavis::host_sim {

/// The congestion that is white in views.
inline constexpr float kFullCongestion = 24;

struct FeatureCongestion {
    double mean = 0;  ///< over all pixels
    FloatMap map;     ///< of the picture's size, not limited to 1; its mean is `mean` within the accuracy of float
};

[[nodiscard]] FeatureCongestion feature_congestion(const LabLevels& picture);

}  // namespace tedavis::host_sim
