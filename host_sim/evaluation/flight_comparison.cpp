#include "host_sim/evaluation/flight_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSameTime_s = 1e-3;

void add(PhaseDifference& sum, double a, double b) {
    const auto count = static_cast<double>(++sum.frames);
    sum.mean_a += (a - sum.mean_a) / count;
    sum.mean_b += (b - sum.mean_b) / count;
    sum.highest_a = std::max(sum.highest_a, a);
    sum.highest_b = std::max(sum.highest_b, b);
}

void pair_up(const EvaluatedFlight& a, const EvaluatedFlight& b, FlightComparison& comparison) {
    const auto time = [](const EvaluatedFlight& flight, std::size_t n) { return flight.run.frames[n].time_s; };
    std::size_t m = 0, n = 0;
    while (m < a.run.frames.size() && n < b.run.frames.size()) {
        const double apart_s = time(a, m) - time(b, n);
        if (std::abs(apart_s) < kSameTime_s)
            comparison.pairs.emplace_back(m++, n++);
        else
            ++(apart_s < 0 ? m : n);
    }
    comparison.only_a = a.run.frames.size() - comparison.pairs.size();
    comparison.only_b = b.run.frames.size() - comparison.pairs.size();
}

void name_runs(const FlightRun& a, const FlightRun& b, FlightComparison& comparison) {
    const bool by_design = !a.design.empty() && !b.design.empty() && a.design != b.design;
    comparison.name_a = by_design ? a.design : a.folder;
    comparison.name_b = by_design ? b.design : b.folder;
}

}  // namespace

FlightComparison compared(const EvaluatedFlight& a, const EvaluatedFlight& b) {
    FlightComparison comparison;
    pair_up(a, b, comparison);
    if (comparison.pairs.empty())
        throw UserError(b.run.folder + ": none of its frames has the time of a frame of " + a.run.folder +
                        "; replay the same log with the same --from and --step");
    comparison.all.phase = "all";
    for (const auto& [m, n] : comparison.pairs) {
        const FlightFrame& frame = a.run.frames[m];
        if (comparison.phases.empty() || comparison.phases.back().phase != frame.phase)
            comparison.phases.push_back({frame.phase, frame.time_s, frame.time_s, 0, 0, 0, 0, 0});
        comparison.phases.back().end_s = frame.time_s;
        add(comparison.phases.back(), a.measures[m].clutter, b.measures[n].clutter);
        add(comparison.all, a.measures[m].clutter, b.measures[n].clutter);
    }
    comparison.all.begin_s = comparison.phases.front().begin_s;
    comparison.all.end_s = comparison.phases.back().end_s;
    name_runs(a.run, b.run, comparison);
    return comparison;
}

std::size_t frame_nearest(const EvaluatedFlight& flight, double time_s) {
    std::size_t best = 0;
    for (std::size_t n = 1; n < flight.run.frames.size(); ++n)
        if (std::abs(flight.run.frames[n].time_s - time_s) < std::abs(flight.run.frames[best].time_s - time_s)) best = n;
    return best;
}

}  // namespace tedavis::host_sim
