#include "host_sim/window/transport.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_transport {
namespace {

using base::Duration;

constexpr Duration kStep = Duration::milliseconds(100);

Transport over(std::uint64_t count) { return {count, kStep, false}; }

TEST(Transport, PlaysAtTheFlightsOwnSpeed) {
    Transport transport = over(1000);
    for (int turn = 0; turn < 30; ++turn) transport.advance(Duration::milliseconds(33));
    EXPECT_EQ(transport.frame(), 9u);  // 990 ms
    transport.advance(Duration::milliseconds(10));
    EXPECT_EQ(transport.frame(), 10u);
}

TEST(Transport, HowTimeIsCutMakesNoDifference) {
    Transport coarse = over(1000), fine = over(1000);
    for (int n = 0; n < 3; ++n) coarse.faster(), fine.slower();
    for (int n = 0; n < 6; ++n) fine.faster();
    for (int n = 0; n < 10; ++n) coarse.advance(Duration::milliseconds(210));
    for (int n = 0; n < 2100; ++n) fine.advance(Duration::milliseconds(1));
    EXPECT_EQ(coarse.speed(), 8);
    EXPECT_EQ(coarse.frame(), 168u);
    EXPECT_EQ(fine.frame(), coarse.frame());
}

TEST(Transport, SpeedsAreBoundedPowersOfTwo) {
    Transport transport = over(10);
    for (int n = 0; n < 20; ++n) transport.faster();
    EXPECT_EQ(transport.speed(), 64);
    for (int n = 0; n < 40; ++n) transport.slower();
    EXPECT_EQ(transport.speed(), 1.0 / 16);
    transport.normal_speed();
    EXPECT_EQ(transport.speed(), 1);
}

TEST(Transport, PausesAtTheEndAndStartsAgain) {
    Transport transport = over(5);
    for (int n = 0; n < 20; ++n) transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 4u);
    EXPECT_FALSE(transport.playing());
    transport.play_or_pause();
    EXPECT_EQ(transport.frame(), 0u);
    transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 1u);
    transport.play_or_pause();
    transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 1u) << "paused";
    transport.play_or_pause();
    EXPECT_EQ(transport.frame(), 1u) << "goes on where it was";
}

TEST(Transport, GoesBackwards) {
    Transport transport(5, kStep, true);
    EXPECT_EQ(transport.frame(), 4u);
    transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 3u);
    transport.reverse();
    transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 4u);
    EXPECT_FALSE(transport.playing());
    transport.reverse();
    transport.play_or_pause();
    for (int n = 0; n < 20; ++n) transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 0u);
    EXPECT_FALSE(transport.playing());
}

TEST(Transport, SeeksWithinTheFlightAndPlaysOn) {
    Transport transport = over(1000);
    transport.seek(Duration::seconds(5));
    EXPECT_EQ(transport.frame(), 50u);
    EXPECT_TRUE(transport.playing());
    transport.seek(Duration::seconds(-60));
    EXPECT_EQ(transport.frame(), 0u);
    transport.seek(Duration::seconds(6000));
    EXPECT_EQ(transport.frame(), 999u);
    transport.to_start();
    EXPECT_EQ(transport.frame(), 0u);
    transport.to_end();
    EXPECT_EQ(transport.frame(), 999u);
}

TEST(Transport, AJumpShorterThanAStepIsAStep) {
    Transport transport(10, Duration::seconds(30), false);
    transport.seek(Duration::seconds(5));
    EXPECT_EQ(transport.frame(), 1u);
    transport.seek(Duration::seconds(-5));
    EXPECT_EQ(transport.frame(), 0u);
}

TEST(Transport, ASingleStepPauses) {
    Transport transport = over(10);
    transport.step(1);
    transport.step(1);
    transport.step(-1);
    EXPECT_EQ(transport.frame(), 1u);
    EXPECT_FALSE(transport.playing());
    transport.step(-1);
    transport.step(-1);
    EXPECT_EQ(transport.frame(), 0u);
}

TEST(Transport, DoesNotLeapAfterAStandstill) {
    Transport transport = over(1000);
    transport.advance(Duration::seconds(3600));
    EXPECT_EQ(transport.frame(), 5u);
}

TEST(Transport, AFlightOfOneFrameStandsStill) {
    Transport transport = over(1);
    transport.advance(kStep);
    transport.step(1);
    transport.seek(Duration::seconds(-5));
    transport.play_or_pause();
    transport.advance(kStep);
    EXPECT_EQ(transport.frame(), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_transport
