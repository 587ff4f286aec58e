#include "host_sim/comparison/comparison_moments.hpp"

#include <cmath>
#include <map>

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

using Reasons = std::map<std::size_t, std::vector<std::string>>;

bool both_have_pictures(const RunComparison& runs, std::size_t instant) {
    return !runs.frame_a(instant).picture.empty() && !runs.frame_b(instant).picture.empty();
}

void add_spread(const RunComparison& runs, Reasons& reasons) {
    constexpr std::size_t kSpread = 6;
    std::vector<std::size_t> pictured, placed;
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        if (!both_have_pictures(runs, n)) continue;
        pictured.push_back(n);
        if (runs.frame_a(n).has_place && runs.frame_b(n).has_place) placed.push_back(n);
    }
    if (!placed.empty()) pictured = placed;  // before the first position the pictures show only what is missing
    for (std::size_t n = 0; n < kSpread && !pictured.empty(); ++n) reasons[pictured[n * (pictured.size() - 1) / (kSpread - 1)]];
}

void add_closest(const RunComparison& runs, Reasons& reasons) {
    const QuantityDifference* const height = runs.find(kHeightAboveTerrain);
    if (height == nullptr || !std::isfinite(height->least_a) || !std::isfinite(height->least_b)) return;
    if (height->least_a_at == height->least_b_at) {
        reasons[height->least_a_at].emplace_back("both are closest to the ground");
        return;
    }
    reasons[height->least_a_at].emplace_back("A is closest to the ground");
    reasons[height->least_b_at].emplace_back("B is closest to the ground");
}

void add_greatest(const RunComparison& runs, Reasons& reasons) {
    for (const std::size_t quantity : {kLabelsPlaced, kDataDrawn, kEffectsDrawn, kHeightAboveTerrain}) {
        const QuantityDifference* const one = runs.find(quantity);
        if (one == nullptr || std::abs(one->greatest) < 1) continue;
        std::string title = kQuantities[quantity].title;
        title[0] = static_cast<char>(title[0] - 'A' + 'a');
        reasons[one->greatest_at].push_back(title + (quantity == kHeightAboveTerrain ? " differs most" : " differ most"));
    }
}

void add_first_differences(const RunComparison& runs, Reasons& reasons) {
    if (runs.first_other_phase) reasons[*runs.first_other_phase].emplace_back("the phases differ first");
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        if (runs.frame_a(n).terrain_alert == runs.frame_b(n).terrain_alert) continue;
        reasons[n].emplace_back("the terrain alerts differ first");
        return;
    }
}

}  // namespace

std::vector<ComparisonMoment> comparison_moments(const RunComparison& runs) {
    Reasons reasons;
    add_spread(runs, reasons);
    add_closest(runs, reasons);
    add_greatest(runs, reasons);
    add_first_differences(runs, reasons);
    std::vector<ComparisonMoment> moments;
    for (const auto& [instant, why] : reasons)
        if (both_have_pictures(runs, instant)) moments.push_back({instant, why});
    return moments;
}

}  // namespace tedavis::host_sim
