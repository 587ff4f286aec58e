#include "host_sim/comparison/comparison_moments.hpp"

#include <cmath>
#include <map>
#include <optional>

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

/// The instant of the frame that is next to the closest point in time; nothing where that is not among those compared.
template <class FrameOf>
std::optional<std::size_t> instant_beside(const RunComparison& runs, const std::optional<RunClosest>& closest, double step_s,
                                          FrameOf frame_of) {
    if (!closest) return std::nullopt;
    std::optional<std::size_t> best;
    double least_s = step_s;
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const double apart_s = std::abs(frame_of(n).time_s - closest->time_s);
        if (apart_s > least_s || (best && apart_s == least_s)) continue;
        best = n;
        least_s = apart_s;
    }
    return best;
}

void add_closest(const RunComparison& runs, Reasons& reasons) {
    const double step_a_s = median_step_s(runs.a) * static_cast<double>(runs.aligned.stride_a),
                 step_b_s = median_step_s(runs.b) * static_cast<double>(runs.aligned.stride_b);
    const auto at_a = instant_beside(runs, runs.closest_a, step_a_s,
                                     [&](std::size_t n) -> const ComparedFrame& { return runs.frame_a(n); }),
               at_b = instant_beside(runs, runs.closest_b, step_b_s,
                                     [&](std::size_t n) -> const ComparedFrame& { return runs.frame_b(n); });
    if (at_a && at_a == at_b) {
        reasons[*at_a].emplace_back("both are closest to the ground");
        return;
    }
    if (at_a) reasons[*at_a].emplace_back("A is closest to the ground");
    if (at_b) reasons[*at_b].emplace_back("B is closest to the ground");
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
