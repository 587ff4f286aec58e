#include "platform/egl_kms/scanout.hpp"

#include <gtest/gtest.h>

#include "tests/platform/egl_kms/fake_screen.hpp"

namespace tedavis::platform::test_scanout {
namespace {

struct ScanoutTest : testing::Test {
    /// Frames at the device's rate, 30 a second; what a frame does to the screen holds after each.
    void frames(int count) {
        for (int n = 0; n < count; ++n) {
            ASSERT_TRUE(buffers.swap()) << "GL has a buffer to draw into at any time";
            ASSERT_TRUE(scanout.show());
            EXPECT_LE(buffers.held.size(), 2u);
            EXPECT_EQ(drm.broken_rules, 0);
            EXPECT_EQ(buffers.released_what_was_not_held, 0);
            drm.clock.ns = (drm.clock.ns / kFrame_ns + 1) * kFrame_ns;
        }
        drawn += static_cast<std::uint64_t>(count);
    }
    static constexpr std::int64_t kFrame_ns = 33'333'333;
    FakeDrm drm;
    FakeBuffers buffers;
    ScreenReport report;
    Scanout scanout{drm, buffers, report, 60000};
    std::uint64_t drawn = 0;
};

TEST_F(ScanoutTest, EveryFrameIsShownAndTheModeIsSetOnce) {
    frames(100);
    EXPECT_EQ(report.flips, 100u);
    EXPECT_EQ(report.missed_flips + report.late_flips + report.hidden_frames, 0u);
    EXPECT_EQ(drm.mode_sets, 1);
    EXPECT_EQ(drm.added, 4) << "each buffer is made known once";
    EXPECT_EQ(report.paced_by, FlipPacing::vblank);
    EXPECT_TRUE(report.is_atomic);
    EXPECT_EQ(drm.longest_wait, kFlipLimit);
}

TEST_F(ScanoutTest, WaitingForTheScreenIsToldFromWork) {
    frames(10);
    EXPECT_GT(report.waited.ns, 0);
    EXPECT_LE(report.waited.ns, FakeDrm::kPeriod_ns);
    drm.flips_hang = true;
    frames(1);
    EXPECT_EQ(report.waited, kFlipLimit);
    frames(1);
    EXPECT_EQ(report.waited.ns, 0) << "it is not waited for again";
    drm.flips_hang = false;
    drm.is_plugged = false;
    frames(60);
    EXPECT_EQ(report.waited.ns, 0);
}

TEST_F(ScanoutTest, SaysWhenTheScreenBeganToShowTheFrame) {
    frames(10);
    const std::int64_t last_frame = drm.clock.ns - kFrame_ns;
    ASSERT_TRUE(report.shown_at.has_value());
    EXPECT_GE(report.shown_at->ns, last_frame);
    EXPECT_LE(report.shown_at->ns, last_frame + FakeDrm::kPeriod_ns);
    drm.flips_hang = true;
    frames(2);
    EXPECT_FALSE(report.shown_at.has_value()) << "it waits for the flip";
    drm.flips_hang = false;
    frames(1);
    ASSERT_TRUE(report.shown_at.has_value());
    EXPECT_GE(report.shown_at->ns, drm.clock.ns - kFrame_ns) << "of this frame, not of the late one before it";
    drm.is_plugged = false;
    frames(60);
    EXPECT_FALSE(report.shown_at.has_value());
}

TEST_F(ScanoutTest, AModeThatIsSetAlreadyIsNotSetAgain) {
    drm.is_lit = true;
    scanout.mode_is_set();
    frames(3);
    EXPECT_EQ(drm.mode_sets, 0);
    EXPECT_EQ(report.flips, 3u);
}

TEST_F(ScanoutTest, AScreenWithoutVerticalBlankingIsPacedByTheTimer) {
    drm.has_vblank = false;
    frames(50);
    EXPECT_EQ(report.flips, 50u);
    EXPECT_EQ(report.paced_by, FlipPacing::timer);
}

TEST_F(ScanoutTest, AFlipThatNeverComesIsCountedAndTheDisplayGoesOn) {
    frames(10);
    drm.flips_hang = true;
    const std::int64_t begun = drm.clock.ns;
    frames(30);
    EXPECT_EQ(report.flips, 10u);
    EXPECT_EQ(report.missed_flips, 30u);
    EXPECT_LT(drm.clock.ns - begun, 30 * kFrame_ns + 2 * kFlipLimit.ns) << "waited for once, not once a frame";
    drm.flips_hang = false;
    frames(10);
    EXPECT_EQ(report.flips, 21u) << "the late one, too";
    EXPECT_EQ(report.missed_flips, 30u);
    EXPECT_EQ(report.late_flips, 1u);
}

TEST_F(ScanoutTest, AScreenThatStandsStillIsSaidAndGivenUp) {
    frames(10);
    drm.flips_hang = true;
    drm.refuses_modes = true;
    const base::Time begun = drm.clock;
    bool is_shown = true;
    double stuck_s = 0, given_up_s = 0;
    for (int n = 0; n < 2000 && is_shown; ++n) {
        ASSERT_TRUE(buffers.swap());
        is_shown = scanout.show();
        drm.clock.ns += FakeDrm::kPeriod_ns;
        const double passed_s = (drm.clock - begun).to_seconds();
        if (report.is_stuck && stuck_s == 0) stuck_s = passed_s;
        given_up_s = passed_s;
    }
    EXPECT_FALSE(is_shown);
    EXPECT_NEAR(stuck_s, kStuckAfter.to_seconds(), 0.3);
    EXPECT_NEAR(given_up_s, kGiveUpAfter.to_seconds(), 0.3);
}

TEST_F(ScanoutTest, FramesThatTakeLongToDrawAreNoStandstill) {
    for (int n = 0; n < 5; ++n) {
        frames(1);
        drm.clock = drm.clock + base::Duration::seconds(20);
        EXPECT_FALSE(report.is_stuck);
    }
    EXPECT_EQ(report.flips, 5u);
    EXPECT_EQ(drm.mode_sets, 1);
}

TEST_F(ScanoutTest, AStandstillMayEndByAModeThatIsSetAnew) {
    frames(10);
    drm.flips_hang = true;
    const int before = drm.mode_sets;
    for (int n = 0; n < 400 && drm.mode_sets == before; ++n) {
        ASSERT_TRUE(buffers.swap());
        ASSERT_TRUE(scanout.show());
        drm.clock.ns += FakeDrm::kPeriod_ns;
    }
    EXPECT_TRUE(report.is_stuck) << "until a flip is confirmed";
    drm.flips_hang = false;
    frames(30);
    EXPECT_EQ(drm.mode_sets, before + 1);
    EXPECT_FALSE(report.is_stuck);
}

TEST_F(ScanoutTest, AHiddenScreenDoesNotStandStill) {
    frames(10);
    drm.is_plugged = false;
    for (int n = 0; n < 900; ++n) {
        ASSERT_TRUE(buffers.swap());
        ASSERT_TRUE(scanout.show()) << n;
        drm.clock.ns += FakeDrm::kPeriod_ns;
    }
    EXPECT_FALSE(report.is_stuck);
}

TEST_F(ScanoutTest, AFlipWhoseEventIsLostIsGivenUpAfterASecond) {
    frames(10);
    drm.loses_events = true;
    frames(20);
    drm.loses_events = false;
    drm.queued = 0;
    frames(60);
    EXPECT_GE(report.flips, 60u);
    EXPECT_LE(report.missed_flips, 31u);
    EXPECT_EQ(drm.mode_sets, 1);
}

TEST_F(ScanoutTest, AnUnpluggedScreenIsNoticedOnceAndComesBackWithItsMode) {
    frames(40);
    const int before = drm.looks_at_connector;
    drm.is_plugged = false;
    frames(90);
    EXPECT_FALSE(report.is_plugged);
    EXPECT_FALSE(drm.is_lit);
    EXPECT_EQ(report.unplugged, 1u);
    EXPECT_GE(report.hidden_frames, 59u);
    EXPECT_LE(drm.looks_at_connector - before, 4) << "at most once a second";
    drm.is_plugged = true;
    frames(90);
    EXPECT_TRUE(report.is_plugged);
    EXPECT_TRUE(drm.is_lit);
    EXPECT_EQ(drm.mode_sets, 2);
    EXPECT_EQ(report.unplugged, 1u);
    EXPECT_EQ(report.flips + report.hidden_frames, drawn);
    EXPECT_EQ(report.missed_flips, 0u);
}

TEST_F(ScanoutTest, AnotherTerminalGetsTheScreenAndGivesItBack) {
    frames(10);
    drm.asked = TerminalRequest::release;
    frames(100);
    EXPECT_EQ(drm.answers, "r") << "the screen is let go before the console is told so";
    EXPECT_EQ(drm.tries_to_become_master, 0) << "it is not ours while the other terminal is in front";
    EXPECT_EQ(report.taken_away, 1u);
    EXPECT_EQ(report.hidden_frames, 100u);
    drm.asked = TerminalRequest::acquire;
    frames(10);
    EXPECT_EQ(drm.answers, "ra");
    EXPECT_TRUE(report.is_master);
    EXPECT_EQ(drm.mode_sets, 2);
    EXPECT_EQ(report.flips, 20u);
}

TEST_F(ScanoutTest, AScreenThatComesBackWithoutHavingBeenAskedForGetsItsModeAnew) {
    frames(10);
    drm.asked = TerminalRequest::acquire;
    frames(10);
    EXPECT_EQ(drm.answers, "a");
    EXPECT_EQ(drm.mode_sets, 2) << "the program between may have left another mode";
    EXPECT_EQ(report.flips, 20u);
    EXPECT_EQ(report.missed_flips, 0u);
}

TEST_F(ScanoutTest, AReleaseThatTheConsoleDidNotAskForChangesNothing) {
    frames(10);
    drm.refuses_answers = true;
    drm.asked = TerminalRequest::release;
    frames(10);
    EXPECT_EQ(drm.answers, "r");
    EXPECT_EQ(report.hidden_frames, 0u);
    EXPECT_EQ(report.taken_away, 0u);
    EXPECT_EQ(report.flips, 20u);
}

TEST_F(ScanoutTest, AMasterThatIsLostIsWonBackOnceItIsFree) {
    frames(10);
    drm.is_master = false;
    drm.others_have_it = true;
    frames(100);
    EXPECT_FALSE(report.is_master);
    EXPECT_EQ(report.taken_away, 1u);
    EXPECT_EQ(report.missed_flips, 1u) << "the one by which it was noticed";
    EXPECT_EQ(report.hidden_frames, 99u);
    EXPECT_LE(drm.tries_to_become_master, 4) << "at most once a second";
    drm.others_have_it = false;
    frames(60);
    EXPECT_TRUE(report.is_master);
    EXPECT_EQ(drm.mode_sets, 2);
    EXPECT_EQ(report.flips + report.hidden_frames + report.missed_flips, drawn);
}

TEST_F(ScanoutTest, AModeThatIsRefusedIsTriedAgainOnceASecond) {
    drm.refuses_modes = true;
    frames(90);
    EXPECT_LE(drm.mode_sets, 4);
    EXPECT_EQ(report.missed_flips, 90u);
    drm.refuses_modes = false;
    frames(60);
    EXPECT_GE(report.flips, 29u);
}

TEST_F(ScanoutTest, AFlipThatIsRefusedSetsTheModeAnew) {
    frames(10);
    drm.refuses_flips = true;
    frames(2);
    EXPECT_EQ(drm.mode_sets, 2);
    EXPECT_EQ(report.missed_flips, 1u);
    drm.refuses_flips = false;
    frames(10);
    EXPECT_EQ(report.flips, 21u);
}

TEST_F(ScanoutTest, BuffersThatTheCardRefusesAreCounted) {
    drm.refuses_framebuffers = true;
    frames(5);
    EXPECT_EQ(report.missed_flips, 5u);
    EXPECT_TRUE(buffers.held.empty());
}

TEST_F(ScanoutTest, ABufferThatEndsIsForgotten) {
    frames(12);
    ASSERT_EQ(drm.known.size(), 4u);
    for (std::size_t n = 0; n < 4; ++n)
        if (buffers.held.count(&buffers.buffers[n]) == 0) buffers.end_buffer(n);
    EXPECT_EQ(drm.known.size(), 1u) << "that which the screen holds";
}

TEST_F(ScanoutTest, MoreBuffersThanAreKeptPushOutThoseThatAreNotInUse) {
    // A new buffer at each frame, as of a driver that keeps none.
    buffers.buffers = std::vector<int>(9);
    frames(30);
    EXPECT_EQ(report.flips, 30u);
    EXPECT_LE(drm.known.size(), 4u);
}

TEST_F(ScanoutTest, ADriverWithoutABufferIsAFailure) {
    frames(2);
    buffers.is_broken = true;
    ASSERT_TRUE(buffers.swap());
    EXPECT_FALSE(scanout.show());
}

TEST_F(ScanoutTest, ACardThatWentAwayWithItsManagerIsAFailureForGood) {
    frames(3);
    drm.asked = TerminalRequest::lost;
    for (int n = 0; n < 3; ++n) {
        ASSERT_TRUE(buffers.swap());
        EXPECT_FALSE(scanout.show()) << "the program must be started again";
    }
}

TEST_F(ScanoutTest, AtTheEndAllIsReturned) {
    frames(10);
    drm.flips_hang = true;
    frames(1);
    EXPECT_EQ(buffers.held.size(), 2u);
    scanout.stop();
    scanout.let_go();
    EXPECT_TRUE(buffers.held.empty());
    EXPECT_TRUE(drm.known.empty());
    EXPECT_EQ(drm.broken_rules + buffers.released_what_was_not_held, 0);
}

}  // namespace
}  // namespace tedavis::platform::test_scanout
