/// The measures of one picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/evaluation/gaze_score.hpp"
#include "render_core/perception/edge_density.hpp"
#include "render_core/perception/edge_detector.hpp"

namespace tedavis::host_sim {

/// Settings of all pictures of an evaluation; equal settings make numbers comparable.
struct EvaluationSettings {
    perception::CannySettings canny;
    perception::RegionGrid grid;
    int saliency_start_level = 0;  ///< perception/saliency_model.hpp: 0 is the reference
};

/// Start level for the frames of a flight: a fifth of the work for nearly the same map. Single pictures and views of moments
/// use the reference.
inline constexpr int kFlightStartLevel = 2;

/// Share of a picture's saliency on the pixels of one layer.
struct LayerShare {
    std::string layer;
    double share = 0;  ///< 0..1 of all saliency
    double area = 0;   ///< 0..1 of all pixels
};

/// Other measures of clutter (feature_congestion.hpp, subband_entropy.hpp).
struct ClutterOpinions {
    double feature_congestion = 0;
    double subband_entropy = 0;  ///< bits
};

struct PictureMeasures {
    std::uint32_t width = 0, height = 0;
    double clutter = 0;                ///< share of pixels that are edges
    std::vector<double> clutter_grid;  ///< of each region, row by row from the upper left
    double saliency_level = 0;         ///< mean saliency on the fixed scale, comparable between pictures
    std::vector<LayerShare> layers;    ///< empty without a layer mask
    std::optional<GazeScore> gaze;
    std::optional<ClutterOpinions> opinions;  ///< of single pictures
};

}  // namespace tedavis::host_sim
