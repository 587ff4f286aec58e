// Signals that are missing for a while, stale or impossible.
#include "render_core/flight/motion_phase_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/render_core/flight/scripted_motion.hpp"

namespace tedavis::flight::test_motion_phase_gaps {
namespace {

using namespace scripted_motion;

TEST(MotionPhaseGaps, a_missing_speed_gives_no_statement) {
    for (const Signal signal : {Signal::ground_speed, Signal::vertical_speed}) {
        base::Time now;
        MotionPhaseState state = cruising(now);
        EXPECT_FALSE(go_on(state, now, 1, [&](AircraftState& a) { a[signal] = {}; }).stated) << to_string(signal);
        EXPECT_EQ(name_of(go_on(state, now, 1, kNoChange)), "cruise") << "a short gap forgets nothing";
        EXPECT_FALSE(go_on(state, now, 11, [&](AircraftState& a) { a[signal] = {}; }).stated);
        EXPECT_FALSE(go_on(state, now, 1, kNoChange).stated) << "after a long gap the phase is found anew";
        EXPECT_EQ(name_of(go_on(state, now, 31, kNoChange)), "cruise");
    }
}

TEST(MotionPhaseGaps, a_missing_height_gives_no_statement_for_ten_seconds) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const auto without = [](AircraftState& a) { a[Signal::height_above_terrain] = {}; };
    EXPECT_FALSE(go_on(state, now, 1, without).stated);
    EXPECT_EQ(name_of(go_on(state, now, 1, kNoChange)), "cruise");
    EXPECT_FALSE(go_on(state, now, 9.9, without).stated);
    EXPECT_EQ(name_of(go_on(state, now, 0.3, without)), "cruise") << "from then on it goes on without one";
    EXPECT_EQ(name_of(go_on(state, now, 15, without, {150, -5, 0, 0})), "approach.descent");
    EXPECT_EQ(name_of(go_on(state, now, 190, without, {150, 0, 0, 0})), "cruise");
    EXPECT_EQ(name_of(go_on(state, now, 1.5, kNoChange, {150, 0, 400, 0})), "unknown") << "low over ground that is known again";
}

TEST(MotionPhaseGaps, stale_bad_and_nan_inputs_count_as_missing) {
    base::Time now;
    const MotionPhaseState state = cruising(now);
    const auto stated_with = [&](const std::function<void(AircraftState&, base::Time)>& change) {
        MotionPhaseState s = state;
        base::Time t = now;
        return go_on(s, t, 0.1, [&](AircraftState& a) { change(a, t); }).stated;
    };
    EXPECT_TRUE(stated_with([](AircraftState&, base::Time) {}));
    EXPECT_FALSE(stated_with([](AircraftState& a, base::Time t) {
        a[Signal::ground_speed] = {150, t - base::Duration::seconds(5)};
    }));
    EXPECT_FALSE(stated_with([](AircraftState& a, base::Time t) { a[Signal::ground_speed] = {150, t, base::Quality::bad}; }));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(stated_with([=](AircraftState& a, base::Time t) { a[Signal::ground_speed] = {bad, t}; }));
        EXPECT_FALSE(stated_with([=](AircraftState& a, base::Time t) { a[Signal::vertical_speed] = {bad, t}; }));
        EXPECT_FALSE(stated_with([=](AircraftState& a, base::Time t) { a[Signal::height_above_terrain] = {bad, t}; }));
    }
}

TEST(MotionPhaseGaps, the_own_ship_estimate_replaces_missing_speeds) {
    base::Time now;
    MotionPhaseState state = cruising(now);
    const auto estimate = [](AircraftState& a) {
        a[Signal::ground_speed] = {};
        a[Signal::vertical_speed] = {};
        a.own_ship.velocity_north_mps = 90;
        a.own_ship.velocity_east_mps = 120;
        a.own_ship.state = base::SignalState::valid;
    };
    EXPECT_TRUE(go_on(state, now, 1, estimate).stated);
    EXPECT_FALSE(go_on(state, now, 1, [&](AircraftState& a) {
                     estimate(a);
                     a.own_ship.state = base::SignalState::stale;
                 }).stated);
}

}  // namespace
}  // namespace tedavis::flight::test_motion_phase_gaps
