#include "platform/egl_kms/flip_clock.hpp"

#include <gtest/gtest.h>

namespace tedavis::platform::test_flip_clock {
namespace {

constexpr std::int64_t kPeriod_ns = 16'666'667;

TEST(FlipClock, SequencesThatCountAreVerticalBlankings) {
    FlipClock clock(60000);
    EXPECT_EQ(clock.paced_by(), FlipPacing::timer) << "one flip says nothing";
    std::uint32_t sequence = 0xfffffffeu;  // and wraps around, through 0
    for (int n = 0; n < 6; ++n, ++sequence) {
        clock.queued({n * kPeriod_ns});
        EXPECT_FALSE(clock.flipped({sequence, {(n + 1) * kPeriod_ns}}));
        EXPECT_EQ(clock.paced_by(), n == 0 ? FlipPacing::timer : FlipPacing::vblank) << n;
    }
}

TEST(FlipClock, SequencesThatStandStillAreNone) {
    FlipClock clock(60000);
    for (int n = 0; n < 10; ++n) {
        clock.queued({n * 1000});
        EXPECT_FALSE(clock.flipped({0, {n * 1000 + 100}}));
        EXPECT_EQ(clock.paced_by(), FlipPacing::timer);
    }
}

TEST(FlipClock, ASequenceThatStopsCountingIsNoticedAndOneRepeatIsNot) {
    FlipClock clock(60000);
    for (const std::uint32_t sequence : {1u, 2u, 2u, 3u, 4u}) (void)clock.flipped({sequence, {}});
    EXPECT_EQ(clock.paced_by(), FlipPacing::vblank);
    for (int n = 0; n < 3; ++n) (void)clock.flipped({4, {}});
    EXPECT_EQ(clock.paced_by(), FlipPacing::timer);
    (void)clock.flipped({5, {}});
    EXPECT_EQ(clock.paced_by(), FlipPacing::vblank);
}

TEST(FlipClock, AFlipBehindTheNextVerticalBlankingIsLate) {
    FlipClock clock(60000);
    clock.queued({1000});
    EXPECT_FALSE(clock.flipped({1, {1000 + kPeriod_ns}}));
    clock.queued({1000});
    EXPECT_FALSE(clock.flipped({2, {1000 + kPeriod_ns * 3 / 2 - 10}}));
    clock.queued({1000});
    EXPECT_TRUE(clock.flipped({3, {1000 + kPeriod_ns * 3 / 2 + 10}}));
    FlipClock half(30000);
    half.queued({1000});
    EXPECT_FALSE(half.flipped({3, {1000 + kPeriod_ns * 3 / 2 + 10}})) << "half the rate, twice the time";
    FlipClock unknown(0);
    unknown.queued({0});
    EXPECT_FALSE(unknown.flipped({1, {1'000'000'000'000}}));
}

}  // namespace
}  // namespace tedavis::platform::test_flip_clock
