#include "target/frame_pacer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

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

/// A screen with blankings: shows what it has been given at the next one, and says when.
struct Screen {
    std::int64_t refresh_ns = 16'683'350;  // 59.94 Hz
    [[nodiscard]] Time blanking_after(Time time) const {
        return {((time.ns - kStart.ns) / refresh_ns + 1) * refresh_ns + kStart.ns};
    }
};

/// How many blankings lie between frames, and the longest time from the beginning of one until it was shown.
struct Shown {
    std::vector<std::int64_t> apart;
    Duration oldest;
};
/// Draws frames as the program does.
Shown draw_on(const Screen& screen, FramePacer& pacer, int frames, const std::function<std::int64_t(int)>& work_ns) {
    Shown shown;
    Time begun = kStart, before = kStart;
    for (int n = 0; n < frames; ++n) {
        const Duration work{work_ns(n)};
        const Time given = std::max(begun + work, pacer.earliest_flip()), at = screen.blanking_after(given);
        if (n > 0) shown.apart.push_back((at - before).ns / screen.refresh_ns);
        if (n > 100) shown.oldest = std::max(shown.oldest, at - begun);
        before = at;
        begun = std::max(at, pacer.next_after({at, {screen.refresh_ns}}, work));
    }
    return shown;
}

TEST(FramePacer, OnAScreenFramesAreEvenlyManyBlankingsApart) {
    struct Case {
        double rate_hz;
        std::int64_t apart;
    };
    for (const auto& [rate_hz, apart] :
         {Case{60, 1}, Case{59, 1}, Case{50, 2}, Case{30, 2}, Case{20, 3}, Case{10, 6}, Case{120, 1}}) {
        FramePacer pacer(rate_hz, kStart);
        const std::int64_t work_ns = 12'000'000;
        const Shown shown = draw_on({}, pacer, 1000, [&](int n) { return work_ns + (n * 7919 % 1'000'000); });
        for (const std::int64_t blankings : shown.apart) ASSERT_EQ(blankings, apart) << rate_hz;
        EXPECT_EQ(pacer.missed(), 0u);
        EXPECT_LT(shown.oldest, Duration{work_ns + 8'000'000}) << "begins as late as its work allows, at " << rate_hz;
    }
}

/// A frame may take the whole time between two that are shown: where it began at a fixed blanking it would have half of it.
TEST(FramePacer, WorkOfNearlyTheWholeTimeBetweenTwoFramesKeepsTheRate) {
    FramePacer pacer(30, kStart);
    for (const std::int64_t blankings : draw_on({}, pacer, 300, [](int) { return 32'000'000; }).apart) ASSERT_EQ(blankings, 2);
}

TEST(FramePacer, AFrameThatIsDrawnFastIsNotShownTooEarly) {
    FramePacer pacer(30, kStart);
    const Shown shown = draw_on({}, pacer, 300, [](int n) { return n % 3 == 0 ? 30'000'000 : 2'000'000; });
    for (const std::int64_t blankings : shown.apart) ASSERT_EQ(blankings, 2);
}

TEST(FramePacer, ALongFrameOnAScreenIsCountedAndNotMadeUpFor) {
    FramePacer pacer(30, kStart);
    const Shown shown = draw_on({}, pacer, 200, [](int n) { return n == 100 ? 90'000'000 : 10'000'000; });
    std::size_t longer = 0;
    for (const std::int64_t blankings : shown.apart) longer += blankings != 2 ? 1 : 0;
    EXPECT_EQ(longer, 1u);
    EXPECT_GE(pacer.missed(), 2u);
    EXPECT_LE(pacer.missed(), 3u);
}

TEST(FramePacer, FromTheScreenBackToTheGridNothingIsMissed) {
    FramePacer pacer(30, kStart);
    const Duration refresh{16'666'667};
    const Time first = kStart + Duration::seconds(100), second = first + Duration{2 * refresh.ns};
    (void)pacer.next_after({first, refresh}, Duration::milliseconds(5));
    const Time due = pacer.next_after({second, refresh}, Duration::milliseconds(5));
    EXPECT_GT(pacer.earliest_flip(), second);
    const Time next = pacer.next(due + Duration::milliseconds(5));
    EXPECT_GT(next, due);
    EXPECT_LE((next - due).to_seconds(), 1 / 30.0 + 1e-8);
    EXPECT_EQ(pacer.earliest_flip(), Time{});
    EXPECT_EQ(pacer.missed(), 0u);
}

}  // namespace
}  // namespace tedavis::target::test_frame_pacer
