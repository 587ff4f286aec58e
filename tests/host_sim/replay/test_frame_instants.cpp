#include "host_sim/replay/frame_instants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Spread over the log, or over a part of it.
FrameInstants spread(std::uint64_t frames, std::optional<double> from = {}, std::optional<double> to = {}, double rate_hz = 30) {
    ReplayOptions options = asked(from, to, {});
    options.spread = frames;
    return {options, kFirst, kLast, rate_hz};
}

TEST(FrameInstants, SpreadAreEvenFramesOfTheDeviceFromEndToEnd) {
    std::set<std::int64_t> whole;
    const FrameInstants all = instants({}, {}, {});
    for (std::uint64_t n = 0; n < all.count(); ++n) whole.insert(all.at(n).ns);
    for (const std::uint64_t frames : {2, 7, 60, 300, 1801}) {
        const FrameInstants times = spread(frames);
        EXPECT_LE(times.count(), frames);
        EXPECT_GE(times.count(), frames * 6 / 7) << "whole frames are no more than a seventh fewer";
        EXPECT_EQ(times.earliest(), kFirst);
        EXPECT_GT(times.latest(), kLast - times.step());
        for (std::uint64_t n = 0; n < times.count(); ++n) EXPECT_EQ(whole.count(times.at(n).ns), 1u) << frames << ' ' << n;
        for (std::uint64_t n = 2; n < times.count(); ++n)
            EXPECT_NEAR((times.at(n) - times.at(n - 1)).to_seconds(), times.step().to_seconds(), 2e-9);
    }
    EXPECT_EQ(spread(5000).count(), 1801u) << "there are no more than the device draws";
}

TEST(FrameInstants, SpreadOverAPartBeginAtItsFirstFrame) {
    const FrameInstants times = spread(11, 10.01, 20);
    EXPECT_NEAR((times.earliest() - kFirst).to_seconds(), 301 / 30.0, 1e-8) << "the device's first frame after 10.01 s";
    EXPECT_LE(times.latest(), kFirst + base::Duration::seconds(20));
    EXPECT_EQ(spread(300, 7.0, 7.0).count(), 1u);
}

TEST(FrameInstants, EventsHaveTheirFramesOnce) {
    FrameInstants times = instants(10, 20, 1);
    const auto at = [](double s) { return kFirst + base::Duration::from_seconds(s); };
    times.add({at(12), at(12.4), at(12.401), at(9), at(20.5), at(12.41), at(25)});
    ASSERT_EQ(times.count(), 13u)
        << "12 is one already; 9 and 25 lie outside; 12.4 is a frame, and 12.401 and 12.41 have the next";
    EXPECT_EQ(times.at(3), at(12.4));
    EXPECT_NEAR((times.at(4) - kFirst).to_seconds(), 373 / 30.0, 1e-8);
    EXPECT_EQ(times.at(5), at(13));
    EXPECT_EQ(times.latest(), at(20));
    for (std::uint64_t n = 1; n < times.count(); ++n) EXPECT_LT(times.at(n - 1), times.at(n));
}

TEST(FrameInstants, NoEventsChangeNothing) {
    FrameInstants times = instants(10, 20, -1);
    times.add({});
    EXPECT_EQ(times.count(), 11u);
    EXPECT_EQ(times.at(0), kFirst + base::Duration::seconds(20)) << "backwards";
}

base::Time at_s(double s) { return kFirst + base::Duration::from_seconds(s); }

/// 20 s in all, of which one part is an instant and one is shorter than a frame.
const TimeRanges kParts = {{at_s(5), at_s(15)}, {at_s(30.01), at_s(30.02)}, {at_s(40.1), at_s(40.1)}, {at_s(49.5), at_s(59.5)}};

std::vector<std::size_t> frames_of_parts(const FrameInstants& times) {
    std::vector<std::size_t> counts(kParts.size());
    for (std::uint64_t n = 0; n < times.count(); ++n) {
        EXPECT_TRUE(contains(kParts, times.at(n))) << n;
        for (std::size_t part = 0; part < kParts.size(); ++part) counts[part] += kParts[part].contains(times.at(n)) ? 1 : 0;
    }
    return counts;
}

TEST(FrameInstants, LieInThePartsAlone) {
    const FrameInstants times(asked({}, {}, 2), kFirst, kLast, 30, kParts);
    EXPECT_EQ(frames_of_parts(times), (std::vector<std::size_t>{6, 1, 1, 6})) << "a part shorter than a step has its begin";
    EXPECT_EQ(times.earliest(), kParts.front().from);
    EXPECT_EQ(times.latest(), kParts.back().to);
    for (const double step : {2.0, 1.0 / 30}) {
        const FrameInstants forward(asked({}, {}, step), kFirst, kLast, 30, kParts);
        const FrameInstants back(asked({}, {}, -step), kFirst, kLast, 30, kParts);
        ASSERT_EQ(forward.count(), back.count());
        for (std::uint64_t n = 0; n < forward.count(); ++n) EXPECT_EQ(back.at(n), forward.at(forward.count() - 1 - n));
    }
}

TEST(FrameInstants, OnePartIsWhatFromAndToWouldAskFor) {
    for (const std::optional<std::uint64_t> frames : {std::optional<std::uint64_t>(), std::optional<std::uint64_t>(23)}) {
        ReplayOptions options = asked({}, {}, {});
        options.spread = frames;
        const FrameInstants part(options, kFirst, kLast, 30, {{at_s(7.123), at_s(31)}});
        options.from_s = 7.123;
        options.to_s = 31;
        const FrameInstants cut(options, kFirst, kLast, 30);
        ASSERT_EQ(part.count(), cut.count());
        for (std::uint64_t n = 0; n < part.count(); ++n) EXPECT_EQ(part.at(n), cut.at(n));
    }
}

TEST(FrameInstants, SpreadOverPartsAreAsManyAsAskedForAtMost) {
    for (const std::uint64_t frames : {8, 20, 300, 5000}) {
        ReplayOptions options = asked({}, {}, {});
        options.spread = frames;
        const FrameInstants times(options, kFirst, kLast, 30, kParts);
        EXPECT_LE(times.count(), frames);
        EXPECT_GE(times.count(), std::min<std::uint64_t>(frames, 602) / 2);
        for (const std::size_t count : frames_of_parts(times)) EXPECT_GE(count, 1u) << "each part is shown";
    }
    ReplayOptions options = asked({}, {}, {});
    options.spread = 2;
    EXPECT_EQ(FrameInstants(options, kFirst, kLast, 30, kParts).count(), 4u) << "more parts than frames have one each";
}

TEST(FrameInstants, EventsBetweenPartsHaveNone) {
    FrameInstants times(asked({}, {}, 2), kFirst, kLast, 30, kParts);
    times.add({at_s(8.5), at_s(20), at_s(58.6), at_s(59.8)});
    EXPECT_EQ(frames_of_parts(times), (std::vector<std::size_t>{7, 1, 1, 7}));
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
