#include "render_core/flight/phase_monitor.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"

namespace tedavis::flight::test_phase_monitor {
namespace {

using base::Duration;
using base::Time;

constexpr Time kStart{1'700'000'000'000'000'000};

/// An aircraft in level cruise at 3000 m above ground.
AircraftState cruising(Time now) {
    AircraftState aircraft;
    aircraft[Signal::ground_speed] = {70, now};
    aircraft[Signal::vertical_speed] = {0, now};
    aircraft[Signal::height_above_terrain] = {3000, now};
    return aircraft;
}

TEST(PhaseMonitor, MotionStatesAPhaseWhereNobodyElseDoes) {
    PhaseMonitor monitor;
    PhaseStatus status;
    for (Time now = kStart; now < kStart + Duration::seconds(120); now = now + PhaseMonitor::kStep)
        status = monitor.step(cruising(now), {}, now);
    EXPECT_EQ(status.source, PhaseSource::motion);
    EXPECT_EQ(status.phase.scenario, Scenario::cruise);
    EXPECT_EQ(monitor.status().phase, status.phase);
}

TEST(PhaseMonitor, AMessageOverrulesMotionAndASwitchOverrulesBoth) {
    PhaseMonitor monitor;
    Time now = kStart;
    const auto run = [&](int seconds, bool message, bool switches) {
        for (const Time end = now + Duration::seconds(seconds); now < end; now = now + PhaseMonitor::kStep) {
            PhaseInputs inputs;
            if (message) inputs.can = {kApproachFinal, now};
            if (switches) inputs.switches = {kGoAroundReplanning, true};
            static_cast<void>(monitor.step(cruising(now), inputs, now));
        }
    };
    run(120, false, false);
    EXPECT_EQ(monitor.status().source, PhaseSource::motion);
    run(3, true, false);
    EXPECT_EQ(monitor.status().source, PhaseSource::can);
    EXPECT_EQ(monitor.status().phase, kApproachFinal);
    run(1, true, true);
    EXPECT_EQ(monitor.status().source, PhaseSource::switches);
    EXPECT_EQ(monitor.status().phase, kGoAroundReplanning);
}

TEST(PhaseMonitor, ACopyGoesOnAsTheOriginalWould) {
    PhaseMonitor original;
    Time now = kStart;
    for (; now < kStart + Duration::seconds(9); now = now + PhaseMonitor::kStep)
        static_cast<void>(original.step(cruising(now), {}, now));
    PhaseMonitor copy = original;
    for (; now < kStart + Duration::seconds(60); now = now + PhaseMonitor::kStep) {
        const PhaseStatus a = original.step(cruising(now), {}, now), b = copy.step(cruising(now), {}, now);
        ASSERT_EQ(a.phase, b.phase);
        ASSERT_EQ(a.source, b.source);
    }
}

}  // namespace
}  // namespace tedavis::flight::test_phase_monitor
