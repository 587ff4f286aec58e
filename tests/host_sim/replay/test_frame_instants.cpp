#include "host_sim/replay/frame_instants.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_frame_instants {
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
}  // namespace tedavis::host_sim::test_frame_instants
