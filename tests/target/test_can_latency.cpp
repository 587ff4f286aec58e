#include "target/can_latency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tedavis::target::test_can_latency {
namespace {

base::Time at_ms(std::int64_t ms) { return {ms * 1'000'000}; }
double ms(base::Duration duration) { return static_cast<double>(duration.ns) / 1e6; }

TEST(CanLatency, CountsFromTheOldestFrameThatThePictureIsTheFirstToHold) {
    CanLatency latency;
    latency.shown(at_ms(100));
    latency.received(at_ms(108));
    latency.received(at_ms(103));
    latency.received(at_ms(120));
    EXPECT_EQ(latency.shown(at_ms(140)), base::Duration::milliseconds(37));
    const LatencyReport report = latency.report();
    EXPECT_EQ(report.pictures, 1u);
    EXPECT_EQ(ms(report.longest), 37);
    EXPECT_DOUBLE_EQ(report.most_pictures, 37.0 / 40);
}

TEST(CanLatency, APictureWithoutNewFramesCountsNothing) {
    CanLatency latency;
    for (int n = 0; n < 10; ++n) EXPECT_EQ(latency.shown(at_ms(33 * n)), std::nullopt);
    EXPECT_EQ(latency.report().pictures, 0u);
    EXPECT_EQ(ms(latency.report().longest), 0);
}

TEST(CanLatency, FramesOfAPictureThatWasNotShownWaitForTheNext) {
    CanLatency latency;
    latency.shown(at_ms(0));
    latency.received(at_ms(10));
    latency.received(at_ms(40));  // of the next picture: the screen has not said that it shows the one before
    latency.shown(at_ms(66));
    EXPECT_EQ(latency.report().pictures, 1u);
    EXPECT_EQ(ms(latency.report().longest), 56);
}

TEST(CanLatency, FramesOfHiddenPicturesAreNotCounted) {
    CanLatency latency;
    latency.shown(at_ms(0));
    for (int n = 1; n < 100; ++n) {
        latency.received(at_ms(33 * n));
        latency.hidden();
    }
    latency.shown(at_ms(3333));  // the first one that is seen has none before it
    latency.received(at_ms(3340));
    latency.shown(at_ms(3366));
    EXPECT_EQ(latency.report().pictures, 1u);
    EXPECT_EQ(ms(latency.report().longest), 26);
}

TEST(CanLatency, AFrameFromTheFutureCountsAsZero) {
    CanLatency latency;
    latency.shown(at_ms(0));
    latency.received(at_ms(50));
    latency.shown(at_ms(33));
    EXPECT_EQ(latency.report().pictures, 1u);
    EXPECT_EQ(ms(latency.report().longest), 0);
}

/// Against sorting all: no percentile is smaller than the true one, nor larger by more than a bin.
TEST(CanLatency, PercentilesAgreeWithThoseOfTheSortedTimes) {
    std::mt19937 random(7);
    std::lognormal_distribution<double> spread(std::log(30.0), 0.5);
    constexpr std::int64_t kPeriod = 2000;
    CanLatency latency;
    std::vector<double> all;
    latency.shown(at_ms(0));
    for (std::int64_t n = 1; n <= 5000; ++n) {
        const double took = std::min(spread(random), 1000.0);
        latency.received({n * kPeriod * 1'000'000 - static_cast<std::int64_t>(took * 1e6)});
        latency.shown(at_ms(n * kPeriod));
        all.push_back(took);
    }
    std::sort(all.begin(), all.end());
    const LatencyReport report = latency.report();
    const double median = all[2499], p99 = all[4949];
    EXPECT_GE(ms(report.median), median - 1e-5);
    EXPECT_LE(ms(report.median), median + 1.00001);
    EXPECT_GE(ms(report.p99), p99 - 1e-5);
    EXPECT_LE(ms(report.p99), p99 + 1.00001);
    EXPECT_NEAR(ms(report.longest), all.back(), 1e-5);
    EXPECT_GE(report.p99_pictures, p99 / kPeriod - 1e-8);
    EXPECT_LE(report.p99_pictures, p99 / kPeriod + 1.0 / 16 + 1e-8);
}

TEST(CanLatency, WhatIsLongerThanAllBinsIsInTheLongest) {
    CanLatency latency;
    for (std::int64_t n = 0; n < 10; ++n) {
        latency.shown(at_ms(10 * n));
        latency.received(at_ms(10 * n - 4000));
    }
    latency.shown(at_ms(100));
    EXPECT_EQ(ms(latency.report().median), 4010);
    EXPECT_EQ(ms(latency.report().p99), 4010);
    EXPECT_DOUBLE_EQ(latency.report().p99_pictures, 401);
}

}  // namespace
}  // namespace tedavis::target::test_can_latency
