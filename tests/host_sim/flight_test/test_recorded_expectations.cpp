#include "host_sim/flight_test/recorded_expectations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace tedavis::host_sim::test_recorded_expectations {
namespace {

constexpr double kRate_hz = 30;

using Flags = std::vector<std::string>;

ObservedFrame frame_of(int n, const char* phase, const Flags& flags, double rate_hz = kRate_hz) {
    ObservedFrame frame;
    frame.time_s = n / rate_hz;
    frame.record.phase.phase = flight::phase_from_name(phase).phase;
    frame.record.design = "default";
    for (const std::string& name : flags) {
        display::Name flag;
        flag = name.c_str();
        EXPECT_TRUE(frame.record.flags.try_push_back(flag));
    }
    return frame;
}

RecordingRule rule() {
    RecordingRule one;
    one.rate_hz = kRate_hz;
    return one;
}

bool has(const std::vector<RecordedFact>& facts, const RecordedFact& wanted) {
    for (const RecordedFact& fact : facts)
        if (fact.kind == wanted.kind && fact.name == wanted.name) return fact.value == wanted.value;
    return wanted.value == kFlagGone;
}

/// What judges do, written anew: an expectation against all frames. What is to be reached must not hold in the last frame up to
/// the window's beginning, and the recording must have seen that frame.
bool holds(const RecordedExpectation& one, const std::vector<ObservedFrame>& frames) {
    bool is_any = false, are_all = true, is_before_known = false, held_before = false;
    for (const ObservedFrame& frame : frames) {
        const auto facts = facts_of(frame, {});
        bool all = true;
        for (const RecordedFact& wanted : one.facts) all = all && has(facts, wanted);
        const bool is_before = frame.time_s <= one.from_s + (one.kind == WindowKind::within ? 1e-6 : -1e-6);
        if (is_before) held_before = all;
        is_before_known = is_before_known || is_before;
        if (is_before || frame.time_s > one.to_s + 1e-6) continue;
        is_any = is_any || all;
        are_all = are_all && all;
    }
    return one.kind == WindowKind::within ? is_any && is_before_known && !held_before : is_any && are_all;
}

std::vector<ObservedFrame> flight(int frames, const std::function<ObservedFrame(int)>& make) {
    std::vector<ObservedFrame> all;
    for (int n = 0; n < frames; ++n) all.push_back(make(n));
    return all;
}

RecordedExpectations expected(const std::vector<ObservedFrame>& frames, const RecordingRule& by) {
    FactTracks tracks({});
    for (const ObservedFrame& frame : frames) tracks.take(frame);
    return expectations_of(tracks, by);
}

TEST(RecordedExpectations, AChangeIsExpectedWithinTheMarginAndWhatLastsBetween) {
    const auto frames = flight(300, [](int n) { return frame_of(n, n < 120 ? "ground" : "cruise", {}); });
    const RecordedExpectations made = expected(frames, rule());
    ASSERT_EQ(made.list.size(), 3u);
    EXPECT_EQ(made.list[0].kind, WindowKind::during);
    EXPECT_EQ(made.list[0].from_s, 0);
    EXPECT_NEAR(made.list[0].to_s, 119 / kRate_hz - 0.5, 0.01);
    EXPECT_EQ(made.list[1].kind, WindowKind::within);
    EXPECT_NEAR(made.list[1].from_s, 3.5, 0.01);
    EXPECT_NEAR(made.list[1].to_s, 4.5, 0.01);
    EXPECT_EQ(made.list[1].words, "4.00 s: the phase becomes cruise.");
    EXPECT_NEAR(made.list[2].from_s, 4.5, 0.01);
    EXPECT_LT(made.list[2].to_s, frames.back().time_s);
    EXPECT_EQ(made.left_out, "");
}

TEST(RecordedExpectations, ChangesCloseToEachOtherAreOne) {
    const auto frames = flight(
        300, [](int n) { return frame_of(n, n < 120 ? "ground" : "cruise", n < 125 ? Flags{} : Flags{"terrain.missing"}); });
    const RecordedExpectations made = expected(frames, rule());
    ASSERT_GE(made.list.size(), 2u);
    std::size_t changes = 0;
    for (const RecordedExpectation& one : made.list) changes += one.kind == WindowKind::within ? 1 : 0;
    EXPECT_EQ(changes, 1u);
}

/// A signal that is stale for a moment becomes valid again: the wait for it begins while it is not.
TEST(RecordedExpectations, AMomentsInterruptionIsExpectedFromItsMiddle) {
    const auto frames = flight(300, [](int n) { return frame_of(n, n == 120 || n == 121 ? "cruise" : "ground", {}); });
    for (const double margin_s : {0.0, 0.5}) {
        RecordingRule by = rule();
        by.margin_s = margin_s;
        std::size_t changes = 0;
        for (const RecordedExpectation& one : expected(frames, by).list) {
            EXPECT_TRUE(holds(one, frames)) << margin_s << " " << one.words;
            changes += one.kind == WindowKind::within ? 1 : 0;
        }
        EXPECT_EQ(changes, 2u) << margin_s;
    }
}

/// A flag that comes and goes within a few frames is waited for in a frame that it is in.
TEST(RecordedExpectations, AFlagOfTwoFramesGoesAfterAFrameThatHasIt) {
    const auto frames =
        flight(300, [](int n) { return frame_of(n, "cruise", n == 120 || n == 121 ? Flags{"terrain.tau_raised"} : Flags{}); });
    std::size_t changes = 0;
    for (const RecordedExpectation& one : expected(frames, rule()).list) {
        EXPECT_TRUE(holds(one, frames)) << one.words;
        if (one.kind != WindowKind::within || one.facts[0].value != kFlagGone) continue;
        ++changes;
        EXPECT_GE(one.from_s, 120 / kRate_hz);
        EXPECT_LT(one.from_s, 122 / kRate_hz);
    }
    EXPECT_EQ(changes, 1u);
}

/// "approach" alone would include the sub-phase from before.
TEST(RecordedExpectations, FromASubPhaseToItsScenarioIsAChange) {
    const auto frames = flight(300, [](int n) { return frame_of(n, n < 120 ? "approach.final" : "approach", {}); });
    const RecordedExpectations made = expected(frames, rule());
    ASSERT_EQ(made.list.size(), 3u);
    EXPECT_EQ(made.list[1].facts[0].value, "approach.none");
    EXPECT_EQ(made.list[1].words, "4.00 s: the phase becomes approach without a sub-phase.");
}

/// Whatever a flight does, what is made of it holds in it; and the windows lie within it.
TEST(RecordedExpectations, OfRestlessFlightsHold) {
    const char* const phases[] = {"ground", "approach", "approach.final", "cruise"};
    const double rates_hz[] = {10, 30, 60, 240};
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        int phase = 0;
        bool flags[3] = {};
        const char* const names[] = {"terrain.missing", "terrain.ahead", "phase.disagreement"};
        const unsigned often = 3 + random() % 60;
        RecordingRule by = rule();
        by.rate_hz = rates_hz[seed % 4];
        const auto frames = flight(60 + static_cast<int>(random() % 400), [&](int n) {
            if (random() % often == 0) phase = static_cast<int>(random() % 4);
            Flags there;
            for (int f = 0; f < 3; ++f) {
                if (random() % often == 0) flags[f] = !flags[f];
                if (flags[f]) there.emplace_back(names[f]);
            }
            return frame_of(n, phases[phase], there, by.rate_hz);
        });
        by.margin_s = static_cast<double>(seed % 5) * 0.2;
        by.expectations = 1000;
        for (const RecordedExpectation& one : expected(frames, by).list) {
            EXPECT_TRUE(holds(one, frames)) << "seed " << seed << " " << one.words;
            EXPECT_LE(one.to_s, frames.back().time_s);
            EXPECT_GE(one.from_s, 0);
            EXPECT_FALSE(one.facts.empty());
        }
    }
}

/// The negative control: a phase that is another one for a second is found.
TEST(RecordedExpectations, OfAnotherFlightDoNotHold) {
    const auto frames = flight(300, [](int n) { return frame_of(n, n < 120 ? "ground" : "cruise", {}); });
    const auto other = flight(300, [](int n) {
        return frame_of(n, n < 120 ? "ground" : n > 200 && n < 230 ? "approach" : "cruise", {});
    });
    const RecordedExpectations made = expected(frames, rule());
    EXPECT_TRUE(holds(made.list[0], other));
    EXPECT_TRUE(holds(made.list[1], other));
    EXPECT_FALSE(holds(made.list[2], other));
}

TEST(RecordedExpectations, WhatMattersLeastIsLeftOutAndSaid) {
    const auto frames = flight(1200, [](int n) {
        return frame_of(n, n < 600 ? "ground" : "cruise", n / 60 % 2 == 0 ? Flags{} : Flags{"terrain.missing"});
    });
    RecordingRule by = rule();
    by.expectations = 4;
    const RecordedExpectations made = expected(frames, by);
    ASSERT_EQ(made.list.size(), 4u);
    std::size_t of_phase = 0;
    for (const RecordedExpectation& one : made.list) of_phase += one.facts.front().kind == FactKind::phase ? 1 : 0;
    EXPECT_EQ(of_phase, 3u);
    EXPECT_THAT(made.left_out, ::testing::HasSubstr("of flags (terrain.missing)"));
}

TEST(RecordedExpectations, OfOneFrameAreWhatItShows) {
    const RecordedExpectation one = expectation_at(2.5, facts_of(frame_of(75, "cruise", {"terrain.missing"}), {}));
    EXPECT_EQ(one.kind, WindowKind::at);
    EXPECT_EQ(one.from_s, 2.5);
    EXPECT_TRUE(has(one.facts, {FactKind::phase, "", "cruise"}));
    EXPECT_TRUE(has(one.facts, {FactKind::flag, "terrain.missing", kFlagThere}));
    for (const RecordedFact& fact : one.facts) EXPECT_NE(fact.value, "missing");
}

}  // namespace
}  // namespace tedavis::host_sim::test_recorded_expectations
