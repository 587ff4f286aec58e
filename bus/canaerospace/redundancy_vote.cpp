#include "bus/canaerospace/redundancy_vote.hpp"

namespace tedavis::bus {
namespace {

int demerits(const base::Stamped<double>& candidate, base::Time now, const base::FreshnessLimits& limits) {
    switch (candidate.state(now, limits)) {
        case base::SignalState::valid: return candidate.quality() == base::Quality::good ? 0 : 1;
        case base::SignalState::stale: return 2;
        case base::SignalState::invalid: return 3;
        case base::SignalState::lost: return 4;
        case base::SignalState::missing: return 5;
    }
    return 5;
}

}  // namespace

std::size_t vote(base::Span<const base::Stamped<double>> candidates, base::Time now,
                 const base::FreshnessLimits& limits) noexcept {
    std::size_t best = 0;
    int best_demerits = 6;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const int own = demerits(candidates[i], now, limits);
        if (own == 0) return i;
        if (own < best_demerits) {
            best = i;
            best_demerits = own;
        }
    }
    return best;
}

}  // namespace tedavis::bus
