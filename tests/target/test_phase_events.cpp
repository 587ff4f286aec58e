#include "target/phase_events.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>

#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_phase_events {
namespace {

using flight::PhaseSource;

base::Time at_us(std::int64_t us) { return base::Time{} + base::Duration{us * 1000}; }

struct Events {
    LogLines lines;
    EventLog log = lines.log();
    PhaseEvents events{log};
};

TEST(PhaseEvents, EachPhaseThatThePictureFollowsIsOneLine) {
    Events board;
    const auto show = [&](flight::PhaseStatus phase, std::uint64_t frame) {
        board.events.report(phase, frame, at_us(1'000'000 * static_cast<std::int64_t>(frame) + 7));
    };
    show(flight::PhaseStatus{}, 1);
    EXPECT_EQ(board.lines.lines(), 0u);
    for (std::uint64_t frame = 2; frame < 5; ++frame) show(flight::stated_phase(flight::kApproachFinal, PhaseSource::can), frame);
    show(flight::stated_phase({flight::Scenario::takeoff, 0}, PhaseSource::switches), 5);
    EXPECT_EQ(board.lines.str(),
              "tedavis-display: phase approach.final of can: frame 2 of 2.000007 s\n"
              "tedavis-display: phase takeoff of switch: frame 5 of 5.000007 s\n");
}

TEST(PhaseEvents, ASourceAndAFaultOfTheSamePhaseAreChanges) {
    Events board;
    flight::PhaseStatus phase = flight::stated_phase({flight::Scenario::ground, 0}, PhaseSource::can);
    board.events.report(phase, 1, at_us(1));
    phase.source = PhaseSource::switches;
    board.events.report(phase, 2, at_us(2));
    phase.switch_fault = true;
    board.events.report(phase, 3, at_us(3));
    EXPECT_EQ(board.lines.str(),
              "tedavis-display: phase ground of can: frame 1 of 0.000001 s\n"
              "tedavis-display: phase ground of switch: frame 2 of 0.000002 s\n"
              "tedavis-display: phase ground of switch+fault: frame 3 of 0.000003 s\n");
}

/// What is stated, and since when, is not what the picture follows.
TEST(PhaseEvents, WhatThePictureDoesNotFollowIsNoLine) {
    Events board;
    flight::PhaseStatus phase = flight::stated_phase({flight::Scenario::cruise, 0}, PhaseSource::can);
    board.events.report(phase, 1, at_us(1));
    phase.phase = flight::kApproachDescent;
    phase.disagreement = true;
    phase.presented_since = at_us(2);
    board.events.report(phase, 2, at_us(2));
    EXPECT_EQ(board.lines.lines(), 1u);
    phase.presented = phase.phase;
    board.events.report(phase, 3, at_us(3));
    EXPECT_EQ(board.lines.lines(), 2u);
}

std::size_t heap_bytes() { return mallinfo2().uordblks; }

TEST(PhaseEvents, KeepsNoHeap) {
    Events board;
    board.events.report(flight::stated_phase(flight::kGoAroundAbort, PhaseSource::can), 1, at_us(1));
    const std::size_t before = heap_bytes();
    board.events.report(flight::stated_phase(flight::kGoAroundReplanning, PhaseSource::switches), 2, at_us(4'000'000'000'000));
    EXPECT_EQ(heap_bytes(), before);
    EXPECT_EQ(board.lines.lines(), 2u);
    void* volatile control = std::malloc(4096);  // volatile: else the compiler leaves both calls out
    EXPECT_GT(heap_bytes(), before);
    std::free(control);
}

}  // namespace
}  // namespace tedavis::target::test_phase_events
