/// Scores how well a saliency map predicts recorded gaze.
///
/// Source: Judd, Durand, Torralba, "A Benchmark of Computational Models of Saliency to Predict Human Fixations",
/// MIT-CSAIL-TR-2012-001 (AUC); Peters, Iyer, Itti, Koch, Vision Research 45, 2005 (NSS). As in the benchmark, a pixel that was
/// looked at counts once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/evaluation/fixation_file.hpp"

namespace tedavis::host_sim {

struct GazeScore {
    std::uint32_t pixels = 0;  ///< that were looked at
    /// 0 to 1, 0.5 for chance: the probability that such a pixel is more salient than one without gaze, counting half of ties.
    /// Judd breaks ties by random jitter, which has this mean.
    double auc = 0;
    std::optional<double> nss;  ///< mean of the map there, in its standard deviations over its mean; nothing for a flat map
};

/// `map` has `width` values a row, finite, one a pixel. Nothing without gaze, and where all pixels were looked at.
[[nodiscard]] std::optional<GazeScore> gaze_score(const std::vector<float>& map, std::uint32_t width,
                                                  const std::vector<GazePixel>& gaze);

}  // namespace tedavis::host_sim
