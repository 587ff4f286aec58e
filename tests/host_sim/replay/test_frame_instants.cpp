#include "host_sim/replay/frame_instants.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/support/expect_user_error.hpp"

namespace tedavis::host_sim {
namespace {

const base::Time kFirst{1'700'000'000'123'456'789};
const base::Time kLast = kFirst + base::Duration::seconds(60);

ReplayOptions asked(std::optional<double> from, std::optional<double> to, std::optional<double> step) {
    ReplayOptions options;
    options.from_s = from;
    options.to_s = to;
    options.step_s = step;
    return options;
}

FrameInstants instants(std::optional<double> from, std::optional<double> to, std::optional<double> step, double rate_hz = 30) {
    return {asked(from, to, step), kFirst, kLast, rate_hz};
}

TEST(FrameInstants, CoverTheLogBothEndsIncluded) {
    const FrameInstants times = instants({}, {}, 0.1);
    EXPECT_EQ(times.count(), 601u);
    EXPECT_EQ(times.at(0), kFirst);
    EXPECT_EQ(times.at(600), kLast);
    EXPECT_EQ(times.at(7), kFirst + base::Duration::milliseconds(700));
}

TEST(FrameInstants, TheRateOfTheDeviceIsTheStep) {
    const FrameInstants times = instants({}, {}, {}, 30);
    EXPECT_EQ(times.count(), 1801u);
    EXPECT_EQ(times.at(30), kFirst + base::Duration::seconds(1)) << "thirty steps are a second, not 10 ns less";
}

// What makes frame T of a part the frame T of the whole run.
TEST(FrameInstants, APartHasTheInstantsOfTheWhole) {
    for (const double rate_hz : {30.0, 60.0, 24.0, 10.0, 7.0}) {
        std::set<std::int64_t> whole;
        const FrameInstants all = instants({}, {}, {}, rate_hz);
        for (std::uint64_t n = 0; n < all.count(); ++n) whole.insert(all.at(n).ns);
        EXPECT_EQ(whole.size(), all.count());
        for (const double from : {1.0, 17.0, 59.0}) {
            const FrameInstants part = instants(from, {}, {}, rate_hz);
            for (std::uint64_t n = 0; n < part.count(); ++n) EXPECT_EQ(whole.count(part.at(n).ns), 1u) << rate_hz << ' ' << n;
            EXPECT_EQ(part.at(part.count() - 1), all.at(all.count() - 1));
        }
    }
}

TEST(FrameInstants, BetweenTheStepsTheStartIsTheOrigin) {
    const FrameInstants times = instants(1.05, 2, 0.1);
    EXPECT_EQ(times.at(0), kFirst + base::Duration::milliseconds(1050));
    EXPECT_EQ(times.at(3), kFirst + base::Duration::milliseconds(1350));
    EXPECT_EQ(times.count(), 10u);
}

TEST(FrameInstants, BackwardsIsTheSameTheOtherWay) {
    const FrameInstants forward = instants(2, 9, 0.5), back = instants(2, 9, -0.5);
    ASSERT_EQ(forward.count(), back.count());
    EXPECT_TRUE(back.backwards());
    for (std::uint64_t n = 0; n < forward.count(); ++n) {
        EXPECT_EQ(back.at(n), forward.at(forward.count() - 1 - n));
        EXPECT_EQ(back.in_order_of_time(n), forward.at(n));
    }
    EXPECT_EQ(back.step(), base::Duration::milliseconds(500));
}

TEST(FrameInstants, WhatComesBeforeAFrameIsOfTheWholeRun) {
    const FrameInstants whole = instants({}, {}, 0.1), part = instants(2, 9, 0.1), back = instants(2, 9, -0.1);
    for (const std::uint64_t n : {0u, 1u, 5u, 40u}) {
        EXPECT_EQ(part.earlier(n, 8), 8u);
        EXPECT_EQ(part.earlier(n, 1000), 20 + n) << "back to the log's start";
        for (std::uint64_t k = 0; k <= 8; ++k) {
            EXPECT_EQ(part.earlier_at(n, k), whole.at(20 + n - k));
            EXPECT_EQ(back.earlier_at(n, k), whole.at(20 + n - k)) << "in order of time, whatever the order of the run";
        }
    }
    EXPECT_EQ(whole.earlier(0, 8), 0u);
    EXPECT_EQ(whole.earlier(3, 8), 3u);
    const FrameInstants off_the_steps = instants(1.05, 2, 0.1);
    EXPECT_EQ(off_the_steps.earlier(0, 8), 0u) << "there its own start is the origin";
    EXPECT_EQ(off_the_steps.earlier_at(3, 2), off_the_steps.at(1));
}

TEST(FrameInstants, EndWithTheLog) {
    EXPECT_EQ(instants(59, 1e9, 0.5).count(), 3u);
    EXPECT_EQ(instants(60, {}, 0.5).count(), 1u);
    EXPECT_EQ(instants(5, 5, 0.5).count(), 1u);
    EXPECT_EQ(instants(0, 0.99, 1).count(), 1u);
}

TEST(FrameInstants, ImpossibleTimesAreRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    using test_support::expect_user_error;
    for (const double from : {-1.0, 61.0, nan, inf})
        expect_user_error([&] { instants(from, {}, 1); }, "which lasts 60 s; choose a time inside it");
    for (const double to : {1.0, nan}) expect_user_error([&] { instants(2, to, 1); }, "lies before --from");
    for (const double step : {0.0, 0.0001, -0.0001, nan, inf}) expect_user_error([&] { instants({}, {}, step); }, "--step");
}

}  // namespace
}  // namespace tedavis::host_sim
