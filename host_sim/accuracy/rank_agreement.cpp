#include "host_sim/accuracy/rank_agreement.hpp"

#include <algorithm>

#include "host_sim/printed_text.hpp"

namespace tedavis::host_sim {
namespace {

/// Negative: a is quicker; positive: b is; 0: the noise hides it.
int rank_of(const MeasuredKnob& knob, const MeasuredLevel& a, const MeasuredLevel& b) {
    return is_quicker(knob, a, b) ? -1 : is_quicker(knob, b, a) ? 1 : 0;
}

const MeasuredLevel* counterpart(const MeasuredKnob& knob, const MeasuredLevel& level) {
    const auto found = std::find_if(knob.levels.begin(), knob.levels.end(),
                                    [&](const MeasuredLevel& other) { return other.name == level.name; });
    return found == knob.levels.end() ? nullptr : &*found;
}

}  // namespace

void RankAgreement::add(const MeasuredKnob& knob, const MeasuredKnob& earlier) {
    for (std::size_t n = 0; n < knob.levels.size(); ++n)
        for (std::size_t m = 0; m < n; ++m) {
            const MeasuredLevel &a = knob.levels[n], &b = knob.levels[m];
            const MeasuredLevel *const a_then = counterpart(earlier, a), *const b_then = counterpart(earlier, b);
            if (a_then == nullptr || b_then == nullptr) continue;
            ++common;
            const int now = rank_of(knob, a, b), then = rank_of(earlier, *a_then, *b_then);
            const double low = std::min(a.ms.median, b.ms.median), high = std::max(a.ms.median, b.ms.median);
            if (high > low * (1 + kDistinct)) {
                ++distinct;
                if (now != 0) ++ranked;
            }
            if (now == 0 || then == 0) continue;
            ++pairs;
            if (now == then) ++alike;
        }
}

std::optional<double> RankAgreement::tau() const {
    if (pairs == 0) return std::nullopt;
    return (2 * static_cast<double>(alike) - static_cast<double>(pairs)) / static_cast<double>(pairs);
}

std::string rank_text(const RankAgreement& ranks) {
    if (ranks.common == 0) return "The reports have no two levels of a setting in common.";
    const std::optional<double> tau = ranks.tau();
    const std::string both = tau ? "Both rank " + std::to_string(ranks.pairs) + " pairs of levels, " +
                                       std::to_string(ranks.alike) + " of them alike (Kendall's tau " + printed("%.3f", *tau) +
                                       ")."
                                 : "The noise hides all ranks from one of the runs.";
    return both + " Of " + std::to_string(ranks.distinct) +
           " pairs whose medians differ by more than 10 % in this run, its noise leaves " + std::to_string(ranks.ranked) +
           " ranked.";
}

}  // namespace tedavis::host_sim
