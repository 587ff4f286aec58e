/// Quantiles and fitted power laws.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tedavis::host_sim {

/// The value below which `share` of the values lie, 0..1, between neighbours linearly (Hyndman and Fan 1996, definition 7).
/// `sorted` ascends and is not empty.
[[nodiscard]] double quantile(const std::vector<double>& sorted, double share);

struct ErrorDistribution {
    double mean = 0, p95 = 0, p99 = 0, max = 0;
    std::size_t count = 0;
};
[[nodiscard]] ErrorDistribution distribution_of(std::vector<double> errors);

struct TimeSpread {
    double median = 0, p5 = 0, p95 = 0;
};
/// `values` is not empty.
[[nodiscard]] TimeSpread spread_of(std::vector<double> values);

/// What 95 of 100 runs of the slowest sample keep to: the median of that sample, times what 95 of 100 runs of all samples are at
/// most of their own sample's median. Runs of one sample alone are too few for such a share. `by_round` has all samples of the
/// first round, then of the second; 0 where it has none.
[[nodiscard]] double kept_time(const std::vector<double>& by_round, std::size_t samples);

struct LawPoint {
    double x, y;
};

/// y ~ factor * x^exponent, by least squares of the logarithms.
struct FittedLaw {
    static constexpr double kMinR2 = 0.9;
    static constexpr std::size_t kMinPoints = 4;

    bool holds = false;  ///< enough points follow it; the rest is 0 where there are too few
    double exponent = 0, factor = 0, r2 = 0;
    double worst_residual = 0;  ///< the greatest ratio of a point to the law, or of the law to a point; 1 or more
    std::string reason;         ///< why it does not hold; empty where it does
};
/// Points with x or y of 0 or below are left out.
[[nodiscard]] FittedLaw fit_law(const std::vector<LawPoint>& points);

}  // namespace tedavis::host_sim
