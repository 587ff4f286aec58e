#include "target/frame_pacer.hpp"

#include <gtest/gtest.h>

namespace tedavis::target::test_frame_pacer {
namespace {

using base::Duration;
using base::Time;

constexpr Time kStart{5'000'000'000};

TEST(FramePacer, KeepsAnEvenGrid) {
    FramePacer pacer(50, kStart);
    for (int n = 1; n <= 1000; ++n) {
        const Time due = pacer.next(kStart + Duration::milliseconds(20 * (n - 1) + 7));
        EXPECT_EQ(due, kStart + Duration::milliseconds(20 * n));
    }
    EXPECT_EQ(pacer.missed(), 0u);
}

TEST(FramePacer, ARateThatDividesNothingDoesNotDrift) {
    FramePacer pacer(30, kStart);
    Time due = kStart;
    for (int n = 0; n < 30 * 3600; ++n) due = pacer.next(due);
    EXPECT_EQ(due, kStart + Duration::seconds(3600));
    EXPECT_EQ(pacer.missed(), 0u);
}

TEST(FramePacer, MissedTurnsAreCountedAndNotMadeUpFor) {
    FramePacer pacer(50, kStart);
    EXPECT_EQ(pacer.next(kStart + Duration::milliseconds(65)), kStart + Duration::milliseconds(80));
    EXPECT_EQ(pacer.missed(), 3u) << "20, 40 and 60 ms";
    EXPECT_EQ(pacer.next(kStart + Duration::milliseconds(81)), kStart + Duration::milliseconds(100));
    EXPECT_EQ(pacer.missed(), 3u);
}

TEST(FramePacer, WhatIsDueAlwaysLiesAhead) {
    for (const double rate : {1.0, 7.0, 29.97, 30.0, 60.0, 144.0, 1000.0}) {
        FramePacer pacer(rate, kStart);
        Time now = kStart, previous = kStart;
        for (int n = 0; n < 5000; ++n) {
            const Time due = pacer.next(now);
            ASSERT_GT(due, now) << rate << " Hz, call " << n;
            ASSERT_GT(due, previous);
            ASSERT_LE((due - now).to_seconds(), 1 / rate + 1e-8);
            previous = due;
            now = due + Duration{(n * 7'919'000LL) % 90'000'000};  // late by up to 90 ms
        }
    }
}

TEST(FramePacer, AnHourOfSilenceIsOneStep) {
    FramePacer pacer(30, kStart);
    const Time now = kStart + Duration::seconds(3600);
    EXPECT_GT(pacer.next(now), now);
    EXPECT_EQ(pacer.missed(), 30u * 3600u);
}

}  // namespace
}  // namespace tedavis::target::test_frame_pacer
