#include "platform/clock/monotonic_clock.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace tedavis::platform::test_monotonic_clock {
namespace {

TEST(MonotonicClock, NeverStepsBack) {
    base::Time last = monotonic_now();
    for (int n = 0; n < 10'000; ++n) {
        const base::Time now = monotonic_now();
        ASSERT_GE(now.ns, last.ns);
        last = now;
    }
}

TEST(MonotonicClock, IsTheClockOfTheStandardLibrary) {
    const auto steady_ns = [] { return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1); };
    const std::int64_t before = steady_ns(), now = monotonic_now().ns, after = steady_ns();
    EXPECT_LE(before, now);
    EXPECT_LE(now, after);
}

}  // namespace
}  // namespace tedavis::platform::test_monotonic_clock
