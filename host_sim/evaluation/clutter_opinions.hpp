/// Two further measures of a picture's clutter, and their rank agreement with the clutter by edges.
#pragma once

#include <string>
#include <vector>

#include "host_sim/evaluation/evaluation_views.hpp"
#include "host_sim/evaluation/order_agreement.hpp"
#include "host_sim/evaluation/picture_measures.hpp"

namespace tedavis::host_sim {

struct MeasuredOpinions {
    ClutterOpinions numbers;
    FloatMap congestion;  ///< Feature Congestion of each pixel divided by kFullCongestion, limited to 1
};

/// Takes two seconds for 1024 x 768 pixels: for single pictures and moments of flights, not for every frame.
[[nodiscard]] MeasuredOpinions clutter_opinions(const RgbaPicture& picture);

/// "Feature Congestion 4.21, Subband Entropy 3.97 bits"
[[nodiscard]] std::string opinions_words(const ClutterOpinions& opinions);

struct OpinionsAgreement {
    OrderAgreement feature_congestion, subband_entropy;  ///< with the clutter by edges
};
/// Compares the orders of pictures; both lists have one entry per picture.
[[nodiscard]] OpinionsAgreement opinions_agreement(const std::vector<double>& clutter,
                                                   const std::vector<ClutterOpinions>& opinions);
/// "Of 15 pairs of peaks Feature Congestion orders 13 as the edges do, Subband Entropy 9."; empty without a pair.
[[nodiscard]] std::string agreement_words(const OpinionsAgreement& agreement, const std::string& things);

}  // namespace tedavis::host_sim
