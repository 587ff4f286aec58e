#include "host_sim/measure/quality_front.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tedavis::host_sim {
namespace {

using effects::QualityLevel;

bool looks_alike(const QualityLevel& level, const QualityLevel& other) {
    return level.error_color == other.error_color && level.error_px == other.error_px;
}

/// Whether the candidate may follow the levels chosen so far.
bool may_follow(const effects::QualityLevels& levels, const QualityCandidate& candidate) {
    if (!(candidate.level.ms + candidate.spread_ms < levels.at[levels.count - 1].ms)) return false;
    effects::QualityLevels longer = levels;
    longer.at[longer.count] = candidate.level;
    return fault_of(longer, longer.count).empty();
}

/// The best candidate within a time; where there is none, the cheapest one; null: none may follow.
const QualityCandidate* next_level(const std::vector<QualityCandidate>& front, const effects::QualityLevels& levels,
                                   double within_ms) {
    const QualityCandidate *best = nullptr, *cheapest = nullptr;
    const auto loss = [](const QualityLevel& level) { return std::make_tuple(level.error_color, level.error_px, level.ms); };
    for (const QualityCandidate& candidate : front) {
        if (!may_follow(levels, candidate)) continue;
        if (cheapest == nullptr || candidate.level.ms < cheapest->level.ms) cheapest = &candidate;
        if (candidate.level.ms > within_ms) continue;
        if (best == nullptr || loss(candidate.level) < loss(best->level)) best = &candidate;
    }
    return best != nullptr ? best : cheapest;
}

}  // namespace

std::vector<QualityCandidate> pareto_front(const std::vector<QualityCandidate>& candidates) {
    if (candidates.empty()) return {};
    const auto is_left_out = [&](const QualityCandidate& candidate) {
        const auto is_richer = [&](const QualityCandidate& other) { return &other < &candidate; };
        return std::any_of(candidates.begin(), candidates.end(), [&](const QualityCandidate& other) {
            return (is_richer(other) && looks_alike(candidate.level, other.level)) || dominates(other.level, candidate.level);
        });
    };
    std::vector<QualityCandidate> front{candidates.front()};
    for (const QualityCandidate& candidate : candidates)
        if (&candidate != &candidates.front() && !is_left_out(candidate)) front.push_back(candidate);
    std::stable_sort(front.begin() + 1, front.end(),
                     [](const QualityCandidate& one, const QualityCandidate& other) { return one.level.ms > other.level.ms; });
    return front;
}

effects::QualityLevels choose_levels(const std::vector<QualityCandidate>& candidates) {
    const std::vector<QualityCandidate> front = pareto_front(candidates);
    effects::QualityLevels levels;
    if (front.empty()) return levels;
    levels.at[0] = front.front().level;
    const double own_ms = front.front().level.ms, cheapest_ms = front.back().level.ms;
    constexpr auto kSteps = static_cast<double>(effects::kQualityLevelCount - 1);
    for (std::size_t n = 1; n < effects::kQualityLevelCount; ++n) {
        const double within_ms = own_ms * std::pow(cheapest_ms / own_ms, static_cast<double>(n) / kSteps);
        const QualityCandidate* const next = next_level(front, levels, within_ms);
        if (next == nullptr) break;
        levels.at[levels.count] = next->level;
        ++levels.count;
    }
    return levels;
}

}  // namespace tedavis::host_sim
