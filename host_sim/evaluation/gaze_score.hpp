/// Scores how well a saliency map predicts recorded gaze.
///
/// Source: Judd, Durand, Torralba, "A Benchmark of Computational Models of Saliency to Predict Human Fixations",
/// MIT-CSAIL-TR-2012-001 (AUC); Peters, Iyer, Itti, Koch, Vision Research 45, 2005 (NSS). As in the benchmark, a fixated pixel
/// counts once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/evaluation/fixation_file.hpp"

namespace tedavis::host_sim {

struct GazeScore {
    std::uint32_t pixels = 0;  ///< number of fixated pixels
    /// 0 to 1, 0.5 for chance: the probability that such a pixel is more salient than one without gaze, counting half of ties.
    /// Judd breaks ties by random jitter, which has this mean.
    double auc = 0;
    /// Mean of the standardized map (mean 0, deviation 1) at the fixated pixels; nothing for a flat map.
    std::optional<double> nss;
};

/// `map` has one finite value per pixel, `width` in a row. Returns nothing without gaze, and where all pixels were fixated.
[[nodiscard]] std::optional<GazeScore> gaze_score(const std::vector<float>& map, std::uint32_t width,
                                                  const std::vector<GazePixel>& gaze);

}  // namespace tedavis::host_sim
