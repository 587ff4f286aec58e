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

// Runs of samples in rounds: `by_round` has all samples of the first round, then of the second.

/// The greatest median time of a sample; 0 without a whole round.
[[nodiscard]] double slowest_median(const std::vector<double>& by_round, std::size_t samples);
/// Each run's time divided by the median of its own sample; empty without a whole round.
[[nodiscard]] std::vector<double> run_ratios(const std::vector<double>& by_round, std::size_t samples);

/// Times that 95 and 99 of 100 runs of the slowest sample do not exceed.
struct KeptTimes {
    double of_95 = 0, of_99 = 0;
};
/// The median of the slowest sample times a quantile of the runs' ratios to the medians of their own samples. The runs of all
/// samples count, since those of one sample are too few for such a quantile. The greater of two quantiles is taken, that of these
/// runs and that of `ratios_beside`, the ratios of other levels in the same rounds, since a level may have been disturbed less
/// than the others by chance.
[[nodiscard]] KeptTimes kept_times(const std::vector<double>& by_round, std::size_t samples, std::vector<double> ratios_beside);

struct LawPoint {
    double x, y;
};

/// y ~ factor * x^exponent, by least squares of the logarithms.
struct FittedLaw {
    static constexpr double kMinR2 = 0.9;
    static constexpr std::size_t kMinPoints = 4;

    bool holds = false;  ///< enough points follow the law; the other figures are 0 where there are too few points
    double exponent = 0, factor = 0, r2 = 0;
    double worst_residual = 0;  ///< the greatest ratio of a point to the law, or of the law to a point; 1 or more
    std::string reason;         ///< why it does not hold; empty where it does
};
/// Points with x or y of 0 or below are left out.
[[nodiscard]] FittedLaw fit_law(const std::vector<LawPoint>& points);

}  // namespace tedavis::host_sim
