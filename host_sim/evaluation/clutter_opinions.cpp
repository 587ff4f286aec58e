#include "host_sim/evaluation/clutter_opinions.hpp"

#include <algorithm>

#include "host_sim/evaluation/feature_congestion.hpp"
#include "host_sim/evaluation/subband_entropy.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {

MeasuredOpinions clutter_opinions(const RgbaPicture& picture) {
    const LabLevels levels(picture);
    FeatureCongestion congestion = feature_congestion(levels);
    for (float& value : congestion.map.values) value = std::min(value / kFullCongestion, 1.0f);
    return {{congestion.mean, subband_entropy(levels)}, std::move(congestion.map)};
}

std::string opinions_words(const ClutterOpinions& opinions) {
    return "Feature Congestion " + decimal(opinions.feature_congestion, 2) + ", Subband Entropy " +
           decimal(opinions.subband_entropy, 2) + " bits";
}

OpinionsAgreement opinions_agreement(const std::vector<double>& clutter, const std::vector<ClutterOpinions>& opinions) {
    std::vector<double> congestion, entropy;
    for (const ClutterOpinions& one : opinions) {
        congestion.push_back(one.feature_congestion);
        entropy.push_back(one.subband_entropy);
    }
    return {order_agreement(clutter, congestion), order_agreement(clutter, entropy)};
}

std::string agreement_words(const OpinionsAgreement& agreement, const std::string& things) {
    const std::size_t pairs = agreement.feature_congestion.pairs;
    if (pairs == 0) return {};
    return "Of " + std::to_string(pairs) + (pairs == 1 ? " pair of " : " pairs of ") + things + " Feature Congestion orders " +
           std::to_string(agreement.feature_congestion.alike) + " as the edges do, Subband Entropy " +
           std::to_string(agreement.subband_entropy.alike) + ".";
}

}  // namespace tedavis::host_sim
