#include "host_sim/accuracy/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_statistics {
namespace {

/// The expected ones are NumPy's (numpy.percentile, its default method).
TEST(Statistics, QuantilesLieBetweenNeighbours) {
    const std::vector<double> values = {1, 2, 4, 8, 16};
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 4);
    EXPECT_DOUBLE_EQ(quantile(values, 0.05), 1.2);
    EXPECT_DOUBLE_EQ(quantile(values, 0.95), 14.4);
    EXPECT_DOUBLE_EQ(quantile(values, 0.99), 15.68);
    EXPECT_DOUBLE_EQ(quantile({3}, 0.7), 3);
}

TEST(Statistics, DistributionsDoNotDependOnTheOrder) {
    const ErrorDistribution d = distribution_of({16, 1, 8, 2, 4});
    EXPECT_DOUBLE_EQ(d.mean, 6.2);
    EXPECT_DOUBLE_EQ(d.p95, 14.4);
    EXPECT_DOUBLE_EQ(d.max, 16);
    EXPECT_EQ(d.count, 5u);
    EXPECT_EQ(distribution_of({}).count, 0u);
    EXPECT_DOUBLE_EQ(spread_of({16, 1, 8, 2, 4}).median, 4);
}

std::vector<LawPoint> law_points(double exponent, double factor) {
    std::vector<LawPoint> points;
    for (const double x : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) points.push_back({x, factor * std::pow(x, exponent)});
    return points;
}

TEST(Statistics, FindsTheLawThatPointsFollow) {
    for (const double exponent : {-2.0, -1.0, 0.5, 3.0}) {
        const FittedLaw law = fit_law(law_points(exponent, 7));
        EXPECT_TRUE(law.holds);
        EXPECT_NEAR(law.exponent, exponent, 1e-12);
        EXPECT_NEAR(law.factor, 7, 1e-11);
        EXPECT_NEAR(law.r2, 1, 1e-12);
        EXPECT_NEAR(law.worst_residual, 1, 1e-12);
    }
}

TEST(Statistics, SaysWhereThereIsNoLaw) {
    const FittedLaw scattered = fit_law({{1, 5}, {2, 0.1}, {4, 7}, {8, 0.2}, {16, 4}});
    EXPECT_FALSE(scattered.holds);
    EXPECT_EQ(scattered.reason.find("R2 is"), 0u) << scattered.reason;
    EXPECT_EQ(fit_law({{1, 1}, {2, 2}, {3, 3}}).reason, "only 3 levels lie on a scale with an error above 0");
    EXPECT_EQ(fit_law({{1, 1}, {2, 2}, {3, 3}, {4, 0}, {0, 5}}).reason, "only 3 levels lie on a scale with an error above 0");
    EXPECT_FALSE(fit_law({{2, 1}, {2, 2}, {2, 3}, {2, 4}}).holds) << "one amount";
}

TEST(Statistics, ResidualsAreTheFarthestPoints) {
    std::vector<LawPoint> points = law_points(-1, 1);
    EXPECT_LT(fit_law(points).worst_residual, 1.001) << "control";
    points[2].y *= 2;
    const double residual = fit_law(points).worst_residual;
    EXPECT_GT(residual, 1.5);
    EXPECT_LT(residual, 2) << "the law itself gives way to the point";
}

/// Three samples with medians of 1, 2 and 4, whose runs are 0.8 to 1.2 of it.
std::vector<double> jittered_rounds() {
    std::vector<double> times;
    for (int round = 0; round <= 100; ++round)
        for (const double median : {1.0, 4.0, 2.0}) times.push_back(median * (0.8 + 0.004 * round));
    return times;
}

TEST(KeptTimes, AreOfTheSlowestSampleAndTheJitterOfAll) {
    const KeptTimes kept = kept_times(jittered_rounds(), 3, {});
    EXPECT_NEAR(kept.of_95, 4 * 1.18, 0.01);
    EXPECT_NEAR(kept.of_99, 4 * 1.196, 0.01);
    EXPECT_LT(spread_of(jittered_rounds()).p95, 4.6) << "all runs together are quicker";
    EXPECT_NEAR(slowest_median(jittered_rounds(), 3), 4, 1e-12);
}

TEST(KeptTimes, OfALevelThatWasDisturbedLessAreThoseOfItsNeighbors) {
    const std::vector<double> calm(50, 1.0), disturbed(50, 1.5);
    EXPECT_DOUBLE_EQ(kept_times({4, 2, 4, 2}, 2, disturbed).of_95, 6);
    EXPECT_DOUBLE_EQ(kept_times({4, 2, 4, 2}, 2, calm).of_95, 4) << "control";
    EXPECT_NEAR(kept_times(jittered_rounds(), 3, calm).of_95, 4 * 1.18, 0.01) << "and its own where they are greater";
}

TEST(KeptTimes, DoNotDependOnTheOrderOfTheRounds) {
    const std::vector<double> times = jittered_rounds();
    std::vector<double> turned(times.end() - 150, times.end());
    turned.insert(turned.end(), times.begin(), times.end() - 150);
    EXPECT_DOUBLE_EQ(kept_times(turned, 3, {}).of_95, kept_times(times, 3, {}).of_95);
}

TEST(KeptTimes, AreZeroWithoutARound) {
    EXPECT_EQ(kept_times({}, 3, {2}).of_95, 0);
    EXPECT_EQ(kept_times({1, 2}, 3, {}).of_95, 0);
    EXPECT_EQ(kept_times({1, 2}, 0, {}).of_95, 0);
    EXPECT_EQ(slowest_median({1, 2}, 3), 0);
    EXPECT_TRUE(run_ratios({1, 2}, 0).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_statistics
