#include "render_core/effects/quality_front.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tedavis::effects {
namespace {

bool looks_alike(const QualityLevel& level, const QualityLevel& other) {
    return level.error_color == other.error_color && level.error_px == other.error_px;
}

/// Whether the candidate may follow the levels chosen so far.
bool may_follow(const QualityLevels& levels, const QualityCandidate& candidate) {
    if (!(candidate.level.ms + candidate.spread_ms < levels.at[levels.count - 1].ms)) return false;
    QualityLevels longer = levels;
    longer.at[longer.count] = candidate.level;
    return fault_of(longer, longer.count).empty();
}

/// The best candidate within a time; where there is none, the cheapest one; null: none may follow.
const QualityCandidate* next_level(const QualityCandidates& front, const QualityLevels& levels, double within_ms) {
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

/// By falling time; those of the same time stay in their order.
void sort_but_the_first(QualityCandidates& front) {
    for (std::size_t n = 2; n < front.size(); ++n)
        for (std::size_t at = n; at > 1 && front[at].level.ms > front[at - 1].level.ms; --at) std::swap(front[at], front[at - 1]);
}

}  // namespace

QualityCandidates pareto_front(const QualityCandidates& candidates) {
    QualityCandidates front;
    if (candidates.empty()) return front;
    const auto is_left_out = [&](const QualityCandidate& candidate) {
        const auto is_richer = [&](const QualityCandidate& other) { return &other < &candidate; };
        return std::any_of(candidates.begin(), candidates.end(), [&](const QualityCandidate& other) {
            return (is_richer(other) && looks_alike(candidate.level, other.level)) || dominates(other.level, candidate.level);
        });
    };
    for (std::size_t n = 0; n < candidates.size(); ++n)
        if (n == 0 || !is_left_out(candidates[n])) static_cast<void>(front.try_push_back(candidates[n]));
    sort_but_the_first(front);
    return front;
}

QualityLevels choose_levels(const QualityCandidates& candidates) {
    const QualityCandidates front = pareto_front(candidates);
    QualityLevels levels;
    if (front.empty()) return levels;
    levels.at[0] = front[0].level;
    const double own_ms = front[0].level.ms, cheapest_ms = front.back().level.ms;
    constexpr auto kSteps = static_cast<double>(kQualityLevelCount - 1);
    for (std::size_t n = 1; n < kQualityLevelCount; ++n) {
        const double within_ms = own_ms * std::pow(cheapest_ms / own_ms, static_cast<double>(n) / kSteps);
        const QualityCandidate* const next = next_level(front, levels, within_ms);
        if (next == nullptr) break;
        levels.at[levels.count] = next->level;
        ++levels.count;
    }
    return levels;
}

}  // namespace tedavis::effects
