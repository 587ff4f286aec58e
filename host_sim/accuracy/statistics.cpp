#include "host_sim/accuracy/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace tedavis::host_sim {
namespace {

struct Sums {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// About the means, so that nothing cancels.
Sums sums_of(const std::vector<LawPoint>& logs) {
    const auto count = static_cast<double>(logs.size());
    Sums sums;
    for (const LawPoint& p : logs) {
        sums.x += p.x / count;
        sums.y += p.y / count;
    }
    for (const LawPoint& p : logs) {
        sums.xx += (p.x - sums.x) * (p.x - sums.x);
        sums.xy += (p.x - sums.x) * (p.y - sums.y);
        sums.yy += (p.y - sums.y) * (p.y - sums.y);
    }
    return sums;
}

/// Of one sample's runs.
double median_of(const std::vector<double>& by_round, std::size_t samples, std::size_t sample) {
    std::vector<double> runs;
    for (std::size_t n = sample; n < by_round.size(); n += samples) runs.push_back(by_round[n]);
    return spread_of(std::move(runs)).median;
}

FittedLaw no_law(std::string reason) {
    FittedLaw law;
    law.reason = std::move(reason);
    return law;
}

}  // namespace

double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), sorted.size() - 1);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

ErrorDistribution distribution_of(std::vector<double> errors) {
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    const double sum = std::accumulate(errors.begin(), errors.end(), 0.0);
    return {sum / static_cast<double>(errors.size()), quantile(errors, 0.95), quantile(errors, 0.99), errors.back(),
            errors.size()};
}

TimeSpread spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.5), quantile(values, 0.05), quantile(values, 0.95)};
}

double slowest_median(const std::vector<double>& by_round, std::size_t samples) {
    double slowest = 0;
    for (std::size_t sample = 0; sample < samples && by_round.size() >= samples; ++sample)
        slowest = std::max(slowest, median_of(by_round, samples, sample));
    return slowest;
}

std::vector<double> run_ratios(const std::vector<double>& by_round, std::size_t samples) {
    std::vector<double> ratios;
    for (std::size_t sample = 0; sample < samples && by_round.size() >= samples; ++sample) {
        const double median = median_of(by_round, samples, sample);
        for (std::size_t n = sample; n < by_round.size(); n += samples) ratios.push_back(median > 0 ? by_round[n] / median : 1);
    }
    return ratios;
}

KeptTimes kept_times(const std::vector<double>& by_round, std::size_t samples, std::vector<double> ratios_beside) {
    std::vector<double> own = run_ratios(by_round, samples);
    if (own.empty()) return {};
    if (ratios_beside.empty()) ratios_beside = own;
    std::sort(own.begin(), own.end());
    std::sort(ratios_beside.begin(), ratios_beside.end());
    const double slowest = slowest_median(by_round, samples);
    const auto kept = [&](double share) { return slowest * std::max(quantile(own, share), quantile(ratios_beside, share)); };
    return {kept(0.95), kept(0.99)};
}

FittedLaw fit_law(const std::vector<LawPoint>& points) {
    std::vector<LawPoint> logs;
    for (const LawPoint& p : points)
        if (p.x > 0 && p.y > 0) logs.push_back({std::log(p.x), std::log(p.y)});
    if (logs.size() < FittedLaw::kMinPoints)
        return no_law("only " + std::to_string(logs.size()) + " levels lie on a scale with an error above 0");
    const Sums sums = sums_of(logs);
    if (!(sums.xx > 0)) return no_law("all levels have the same amount");
    FittedLaw law;
    law.exponent = sums.xy / sums.xx;
    law.factor = std::exp(sums.y - law.exponent * sums.x);
    law.r2 = sums.yy > 0 ? sums.xy * sums.xy / (sums.xx * sums.yy) : 0;
    for (const LawPoint& p : logs)
        law.worst_residual = std::max(law.worst_residual, std::exp(std::abs(p.y - sums.y - law.exponent * (p.x - sums.x))));
    law.holds = law.r2 >= FittedLaw::kMinR2;
    if (law.holds) return law;
    char reason[80];
    std::snprintf(reason, sizeof reason, "R2 is %.2f, below %.1f", law.r2, FittedLaw::kMinR2);
    law.reason = reason;
    return law;
}

}  // namespace tedavis::host_sim
