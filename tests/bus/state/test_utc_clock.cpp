#include "bus/state/utc_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "tests/support/files/hard_case.hpp"

namespace tedavis::bus::test_utc_clock {
namespace {

using base::Duration;
using base::SignalState;

constexpr std::int64_t kNoon = 1'780'315'200;  // 2026-06-01T12:00:00Z
constexpr std::int64_t kDay = 86'400;

/// Sends UTC as the C library splits it, once a second, on a source whose clock began with the first message.
class UtcBus {
public:
    explicit UtcBus(std::int64_t utc_s = kNoon) : first_(utc_s) {}

    void time(std::int64_t utc_s, double at_s, int second_offset = 0) {
        const std::tm parts = split(utc_s);
        clock.take_time({byte(parts.tm_hour), byte(parts.tm_min), byte(parts.tm_sec + second_offset)},
                        at(at_s) + UtcClock::kTransport);
    }
    void date(std::int64_t utc_s, double at_s) {
        const std::tm parts = split(utc_s);
        clock.take_date(parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday, at(at_s) + UtcClock::kTransport);
    }
    void both(std::int64_t utc_s, double at_s) {
        time(utc_s, at_s);
        date(utc_s, at_s);
    }
    /// Messages of the source's own seconds `from`..`to`, `late_s` behind.
    void fly(int from, int to, double late_s = 0) {
        for (int second = from; second <= to; ++second) both(first_ + second, second + late_s);
    }
    [[nodiscard]] flight::UtcEstimate estimate(double at_s) const { return clock.estimate(at(at_s)); }
    /// Seconds by which the clock is ahead of the true UTC.
    [[nodiscard]] double error_s(double at_s) const {
        return (at(0) + estimate(at_s).ahead - base::Time{first_ * 1'000'000'000}).to_seconds();
    }
    [[nodiscard]] bool is_valid(double at_s) const { return estimate(at_s).state == SignalState::valid; }

    UtcClock clock{Duration::seconds(10)};

private:
    static std::uint8_t byte(int value) { return static_cast<std::uint8_t>(value); }
    static std::tm split(std::int64_t utc_s) {
        const std::time_t time = utc_s;
        std::tm parts{};
        EXPECT_NE(gmtime_r(&time, &parts), nullptr);
        return parts;
    }
    static base::Time at(double seconds) { return base::Time{} + Duration::from_seconds(5000 + seconds); }

    std::int64_t first_;
};

TEST(UtcClock, NeedsBothMessagesInEitherOrder) {
    UtcBus bus;
    EXPECT_EQ(bus.estimate(0).state, SignalState::missing);
    bus.time(kNoon, 0);
    EXPECT_EQ(bus.estimate(0).state, SignalState::missing) << "of which day?";
    bus.date(kNoon, 0.4);
    EXPECT_TRUE(bus.is_valid(0.4));
    EXPECT_EQ(bus.error_s(0.4), 0);
    UtcBus dated;
    dated.date(kNoon, -30);
    EXPECT_EQ(dated.estimate(0).state, SignalState::missing);
    dated.time(kNoon, 0);
    EXPECT_EQ(dated.error_s(0), 0);
}

TEST(UtcClock, IsLostWithoutMessagesAndGoesOn) {
    UtcBus bus;
    bus.fly(0, 20);
    EXPECT_TRUE(bus.is_valid(30));
    EXPECT_EQ(bus.estimate(30.1).state, SignalState::lost);
    EXPECT_EQ(bus.error_s(100), 0) << "by the source's clock";
    bus.time(kNoon + 100, 100);
    EXPECT_TRUE(bus.is_valid(100)) << "a date is not asked for again";
    EXPECT_EQ(bus.estimate(80).state, SignalState::lost) << "nor is a message from the future believed";
}

TEST(UtcClock, SecondsAreCutOffAndMessagesComeLate) {
    UtcBus bus;
    for (int n = 0; n < 200; ++n) {
        const int second = n / 5;
        bus.both(kNoon + second, second + (n % 5) * 0.2 + (n % 7) * 0.01);
    }
    EXPECT_NEAR(bus.error_s(40), 0, 0.02) << "the largest offset is the nearest";
    UtcBus late;
    late.fly(0, 9, 0.7);
    EXPECT_NEAR(late.error_s(9), -0.7, 1e-9);
    late.fly(10, 20, 0.1);
    EXPECT_NEAR(late.error_s(20), -0.1, 1e-9);
}

/// The naive form: the day of the last date and the time of day of the last time, joined.
std::int64_t joined(std::int64_t date_utc_s, std::int64_t time_utc_s) {
    return date_utc_s - date_utc_s % kDay + time_utc_s % kDay;
}

TEST(UtcClock, MidnightComesOnceHoweverTheMessagesStand) {
    double worst_s = 0, naive_s = 0;
    for (const double date_late_s : {-2.0, -0.5, 0.5, 3.0}) {
        UtcBus bus(kNoon + kDay / 2 - 30);  // half a minute before midnight
        for (int second = 0; second < 60; ++second) {
            const std::int64_t utc_s = kNoon + kDay / 2 - 30 + second,
                               dated_s = kNoon + kDay / 2 - 30 + static_cast<std::int64_t>(std::floor(second - date_late_s));
            bus.time(utc_s, second);
            bus.date(dated_s, second);
            naive_s = std::fmax(naive_s, std::fabs(static_cast<double>(joined(dated_s, utc_s) - utc_s)));
            if (second > 3) {
                ASSERT_TRUE(bus.is_valid(second)) << second;
                ASSERT_EQ(bus.error_s(second), 0) << second;
                worst_s = std::fmax(worst_s, std::fabs(bus.error_s(second)));
            }
        }
    }
    EXPECT_EQ(naive_s, kDay) << "control: a day off";
    test_support::record_worst("A66", worst_s);
    test_support::record_control("A66", naive_s);
}

TEST(UtcClock, NothingBeginsAtMidnightItself) {
    UtcBus bus(kNoon + kDay / 2 - 2);
    bus.time(kNoon + kDay / 2, 2);  // the date is still the old one's
    bus.date(kNoon + kDay / 2 - 1, 2.01);
    EXPECT_EQ(bus.estimate(2.1).state, SignalState::missing) << "a day off";
    bus.fly(3, 10);
    EXPECT_EQ(bus.error_s(10), 0);
    UtcBus dated_yesterday;
    dated_yesterday.date(kNoon - kDay, -46'800);  // thirteen hours before noon: a day that is over
    dated_yesterday.time(kNoon, 0);
    EXPECT_EQ(dated_yesterday.estimate(0).state, SignalState::missing);
}

TEST(UtcClock, ALeapSecondIsTheNextDaysFirst) {
    UtcBus bus(kNoon + kDay / 2 - 30);
    bus.fly(0, 29);
    bus.time(kNoon + kDay / 2 - 1, 30, +1);  // 23:59:60
    EXPECT_EQ(bus.error_s(30), 0);
    for (int second = 31; second < 60; ++second) bus.both(kNoon + kDay / 2 - 31 + second, second);
    EXPECT_TRUE(bus.is_valid(59));
    EXPECT_NEAR(bus.error_s(59), 0, 1) << "a second less from there on";
}

TEST(UtcClock, OneWrongMessageChangesNothing) {
    UtcBus bus;
    bus.fly(0, 10);
    bus.time(kNoon - 5000, 10.5);
    bus.time(kNoon - 9000, 10.6);
    bus.date(kNoon + 40 * kDay, 10.7);
    EXPECT_EQ(bus.error_s(11), 0);
    EXPECT_TRUE(bus.is_valid(19));
    bus.fly(11, 20);
    EXPECT_EQ(bus.error_s(20), 0);
    bus.clock.take_time({24, 0, 0}, base::Time{});
    bus.clock.take_time({12, 60, 0}, base::Time{});
    bus.clock.take_date(2026, 2, 30, base::Time{});
    EXPECT_EQ(bus.error_s(20), 0);
}

TEST(UtcClock, UtcThatRunsBackwardsIsNotConfirmed) {
    UtcBus bus;
    bus.fly(0, 5);
    for (int second = 1; second < 30; ++second) bus.time(kNoon + 5 - 3 * second, 5 + second);
    EXPECT_EQ(bus.error_s(30), 0);
    EXPECT_EQ(bus.estimate(30).state, SignalState::lost);
}

TEST(UtcClock, AClockThatWasSetIsFollowed) {
    UtcBus bus;
    bus.fly(0, 10);
    bus.time(kNoon + 11 + 18, 11);
    bus.time(kNoon + 12 + 18, 12);
    EXPECT_EQ(bus.error_s(12), 0) << "not yet";
    bus.time(kNoon + 13 + 18, 13);
    EXPECT_EQ(bus.error_s(13), 18) << "leap seconds, say";
    EXPECT_TRUE(bus.is_valid(13));
}

TEST(UtcClock, AfterALargeStepTheDateIsAskedForAgain) {
    constexpr std::int64_t kStep = 5 * 3600;
    UtcBus bus;
    bus.fly(0, 10);
    for (int second = 11; second < 15; ++second) bus.time(kNoon + second + kStep, second);
    EXPECT_EQ(bus.estimate(15).state, SignalState::lost);
    bus.date(kNoon + kStep, 15);
    EXPECT_TRUE(bus.is_valid(15));
    EXPECT_EQ(bus.error_s(15), kStep);
}

TEST(UtcClock, AnotherDateOfTheSameTimeIsBelievedAtTheThird) {
    UtcBus bus;
    bus.fly(0, 10);
    for (int second = 11; second < 14; ++second) {
        EXPECT_EQ(bus.error_s(second), 0);
        bus.time(kNoon + second, second);
        bus.date(kNoon + 3 * kDay, second);
    }
    EXPECT_NEAR(bus.error_s(14), 3 * kDay, 1e-6);
}

TEST(UtcClock, DatesOfReceiversWithoutAFixAreIgnored) {
    UtcBus bus;
    bus.both(315'964'800 + 43'200, 0);  // 1980-01-06, where GPS time begins
    bus.clock.take_date(0, 0, 0, base::Time{});
    bus.clock.take_date(2100, 6, 1, base::Time{});
    EXPECT_EQ(bus.estimate(0).state, SignalState::missing);
    bus.fly(1, 2);
    EXPECT_EQ(bus.error_s(2), 0);
}

}  // namespace
}  // namespace tedavis::bus::test_utc_clock
