#include "bus/state/source_time_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/files/hard_case.hpp"

namespace tedavis::bus::test_source_time_fit {
namespace {

constexpr std::int64_t kEpoch = 1'700'000'000'000'000'000;

struct Sent {
    std::uint8_t code;
    std::int64_t sent_ns;
    std::int64_t received_ns;
};

/// A sender of `period_ms` whose messages take 0..`jitter_ms` (evenly spread) to arrive; some are lost.
std::vector<Sent> periodic(int count, double period_ms, double jitter_ms, double loss, unsigned seed, double drift_ppm = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> delay(0, jitter_ms);
    std::uniform_real_distribution<double> chance(0, 1);
    std::vector<Sent> messages;
    for (int i = 0; i < count; ++i) {
        const auto sent = kEpoch + static_cast<std::int64_t>(i * period_ms * (1 + drift_ppm * 1e-6) * 1e6);
        const auto received = sent + static_cast<std::int64_t>(delay(random) * 1e6);
        if (chance(random) >= loss) messages.push_back({static_cast<std::uint8_t>(i), sent, received});
    }
    return messages;
}

/// Root mean square of the fit's error about its mean (the mean is transport delay), seconds, once settled.
double scatter_after(const std::vector<Sent>& messages, std::size_t settled, bool use_fit, int* unlocked = nullptr) {
    SourceTimeFit fit;
    double sum = 0;
    double squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const SourceTime time = fit.add(messages[i].code, {messages[i].received_ns});
        if (i < settled) continue;
        if (unlocked != nullptr && !time.locked) ++*unlocked;
        const double error = static_cast<double>((use_fit ? time.time.ns : messages[i].received_ns) - messages[i].sent_ns) * 1e-9;
        sum += error;
        squares += error * error;
        ++count;
    }
    const double mean = sum / count;
    return std::sqrt(squares / count - mean * mean);
}

TEST(SourceTimeFit, TenTimesBetterThanReceiveStamps) {
    for (const double period_ms : {12.5, 50.0, 100.0}) {
        const std::vector<Sent> messages = periodic(3000, period_ms, 10, 0.02, 3);
        int unlocked = 0;
        const double fitted = scatter_after(messages, 1000, true, &unlocked);
        const double received = scatter_after(messages, 1000, false);
        EXPECT_EQ(unlocked, 0) << period_ms;
        EXPECT_LT(fitted * 10, received) << period_ms << " ms";
    }
}

TEST(SourceTimeFit, FindsThePeriodOfADriftingClock) {
    SourceTimeFit fit;
    for (const Sent& message : periodic(2000, 20, 5, 0.05, 4, 100)) (void)fit.add(message.code, {message.received_ns});
    EXPECT_TRUE(fit.locked());
    EXPECT_NEAR(fit.period_s(), 0.020 * (1 + 100e-6), 1e-6);
}

TEST(SourceTimeFit, NoLockBeforeEnoughMessagesAndThenReceiveStampsServe) {
    SourceTimeFit fit;
    const std::vector<Sent> messages = periodic(100, 50, 2, 0, 5);
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const SourceTime time = fit.add(messages[i].code, {messages[i].received_ns});
        EXPECT_EQ(time.locked, i + 1 >= SourceTimeFit::kMessagesToLock) << i;
        EXPECT_TRUE(time.locked || time.time.ns == messages[i].received_ns) << i;
    }
}

TEST(SourceTimeFit, EventMessagesDoNotLock) {
    std::mt19937 random(6);
    std::exponential_distribution<double> gap(2.0);
    SourceTimeFit fit;
    std::int64_t now = kEpoch;
    int locked = 0;
    for (int i = 0; i < 500; ++i) {
        now += static_cast<std::int64_t>(gap(random) * 1e9);
        locked += fit.add(static_cast<std::uint8_t>(i), {now}).locked ? 1 : 0;
    }
    EXPECT_LT(locked, 75) << "of 500; by chance some runs look steady";
}

TEST(SourceTimeFit, ABurstAfterABusyBusDoesNotMoveTheLine) {
    SourceTimeFit fit;
    std::vector<Sent> messages = periodic(400, 20, 1, 0, 7);
    for (std::size_t i = 200; i < 208; ++i) messages[i].received_ns = messages[208].received_ns;
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const SourceTime time = fit.add(messages[i].code, {messages[i].received_ns});
        if (i < 100) continue;
        ASSERT_NEAR(static_cast<double>(time.time.ns - messages[i].sent_ns), 0.5e6, 0.8e6) << i;
    }
}

TEST(SourceTimeFit, AChangedPeriodIsLearntAgain) {
    SourceTimeFit fit;
    const std::vector<Sent> slow = periodic(300, 100, 1, 0, 8);
    for (const Sent& message : slow) (void)fit.add(message.code, {message.received_ns});
    const std::int64_t start = slow.back().received_ns;
    bool locked = false;
    for (int i = 1; i <= 60; ++i)
        locked = fit.add(static_cast<std::uint8_t>(slow.back().code + i), {start + i * 20'000'000ll}).locked;
    EXPECT_TRUE(locked);
    EXPECT_NEAR(fit.period_s(), 0.020, 1e-4);
}

/// By how much an interval in floats of seconds since an epoch, the naive form, is off, s.
double float_interval_off_s(std::int64_t from_ns, std::int64_t to_ns) {
    const auto from = static_cast<float>(static_cast<double>(from_ns) * 1e-9),
               to = static_cast<float>(static_cast<double>(to_ns) * 1e-9);
    return std::abs(double{to - from} - static_cast<double>(to_ns - from_ns) * 1e-9);
}

/// Also where a counter of milliseconds in 32 bits wraps on the way, after 49.7 days.
TEST(SourceTimeFit, AnotherEpochGivesTheSameBits) {
    double worst_s = 0, naive_s = 0;
    for (const std::int64_t epoch :
         {86'400'000'000'000, 4'294'966'000'000'000, 5'184'000'000'000'000, 8'000'000'000'000'000'000}) {
        SourceTimeFit early;
        SourceTimeFit late;
        for (const Sent& message : periodic(1000, 12.5, 5, 0.02, 9)) {
            const std::int64_t since = message.received_ns - kEpoch;
            const SourceTime a = early.add(message.code, {since});
            const SourceTime b = late.add(message.code, {since + epoch});
            ASSERT_EQ(a.time.ns, b.time.ns - epoch);
            ASSERT_EQ(a.locked, b.locked);
            worst_s = std::max(worst_s, std::abs(static_cast<double>(b.time.ns - epoch - a.time.ns)) * 1e-9);
            if (epoch < 86'400'000'000'001) naive_s = std::max(naive_s, float_interval_off_s(epoch, epoch + since));
        }
    }
    EXPECT_GT(naive_s, 1e-3) << "control: after one day";
    EXPECT_LT(float_interval_off_s(0, 12'500'000), 1e-8) << "which does not show at the start";
    test_support::record_worst("A17", worst_s);
    test_support::record_control("A17", naive_s);
}

TEST(SourceTimeFit, AnyStampsGiveAnswersNearTheirStamp) {
    std::mt19937_64 random(10);
    SourceTimeFit fit;
    std::int64_t now = kEpoch;
    for (int i = 0; i < 200000; ++i) {
        const std::uint64_t kind = random() % 20;
        now += kind == 0 ? static_cast<std::int64_t>(random() % 100'000'000'000) - 50'000'000'000
                         : static_cast<std::int64_t>(random() % 40'000'000);
        const SourceTime time =
            fit.add(static_cast<std::uint8_t>(random() % 8 == 0 ? random() : static_cast<std::uint64_t>(i)), {now});
        ASSERT_LE(std::llabs(time.time.ns - now), 500'000'000);
        ASSERT_TRUE(std::isfinite(fit.period_s()));
    }
}

}  // namespace
}  // namespace tedavis::bus::test_source_time_fit
