#include "host_sim/accuracy/next_level.hpp"

#include <algorithm>

namespace tedavis::host_sim {

std::vector<NextLevel> next_levels(const MeasuredKnob& knob) {
    std::vector<const MeasuredLevel*> front;
    for (const MeasuredLevel& level : knob.levels)
        if (level.is_offered && !level.is_dominated) front.push_back(&level);
    std::sort(front.begin(), front.end(),
              [](const MeasuredLevel* a, const MeasuredLevel* b) { return a->ms.median < b->ms.median; });
    std::vector<NextLevel> steps;
    for (std::size_t n = 1; n < front.size(); ++n) {
        const MeasuredLevel &from = *front[n - 1], &to = *front[n];
        const auto ratio = [](double a, double b) { return b > 0 ? a / b : 0; };
        steps.push_back({&from, &to, ratio(to.error.mean, from.error.mean), ratio(to.ms.median, from.ms.median),
                         static_cast<double>(to.bytes) - static_cast<double>(from.bytes)});
    }
    return steps;
}

}  // namespace tedavis::host_sim
