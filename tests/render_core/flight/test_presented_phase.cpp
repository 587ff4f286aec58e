#include "render_core/flight/presented_phase.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::flight::test_presented_phase {
namespace {

constexpr FlightPhase kCruise{Scenario::cruise, 0};

/// Follows phases that are in effect from their seconds on, by steps of 20 ms as the phase monitor does.
class Followed {
public:
    struct From {
        double second;
        FlightPhase phase;
    };
    explicit Followed(std::vector<From> phases) : phases_(std::move(phases)) {}

    PhaseStatus until(double second) {
        for (; step_ * kStep_s <= second; ++step_) {
            const double now = step_ * kStep_s;
            for (const From& from : phases_)
                if (from.second <= now + 1e-9) status_.phase = from.phase;
            const FlightPhase before = status_.presented;
            follow_phase(status_, base::Time{} + base::Duration::from_seconds(now), state_);
            turns_ += step_ > 0 && status_.presented != before ? 1 : 0;
        }
        return status_;
    }
    [[nodiscard]] int turns() const { return turns_; }

private:
    static constexpr double kStep_s = 0.02;
    std::vector<From> phases_;
    PresentedPhaseState state_;
    PhaseStatus status_;
    int step_ = 0, turns_ = 0;
};

TEST(PresentedPhase, AfterCalmATurnIsFollowedAtOnce) {
    Followed flight({{0, kTakeoffStart}, {10, kCruise}});
    EXPECT_EQ(flight.until(9.98).presented, kTakeoffStart);
    const PhaseStatus after = flight.until(10.0);
    EXPECT_EQ(after.presented, kCruise);
    EXPECT_EQ(after.presented_since.ns, 10'000'000'000);
}

TEST(PresentedPhase, ABounceTurnsThePictureOnce) {
    // Out of calm to cruise and back and forth for three seconds, at cruise from 13 s on.
    std::vector<Followed::From> bounces{{0, kTakeoffStart}};
    for (int n = 0; n < 15; ++n) bounces.push_back({10 + 0.2 * n, n % 2 == 0 ? kCruise : kTakeoffStart});
    Followed flight(bounces);
    static_cast<void>(flight.until(30));
    // To cruise at once, back to terrain as a turn to it is never put off, and to cruise for good when that has lasted.
    EXPECT_EQ(flight.turns(), 3);
    EXPECT_EQ(flight.until(30).presented, kCruise);
    EXPECT_EQ(flight.until(30).presented_since.ns, 14'800'000'000);
}

TEST(PresentedPhase, WhileTwoSourcesTakeTurnsTerrainStays) {
    std::vector<Followed::From> turns{{0, kCruise}};
    for (int n = 0; n < 100; ++n) turns.push_back({10 + 0.5 * n, n % 2 == 0 ? kApproachFinal : kCruise});
    Followed flight(turns);
    for (double second = 10; second < 59; second += 0.5) EXPECT_EQ(flight.until(second).presented, kApproachFinal) << second;
    EXPECT_EQ(flight.turns(), 1);
}

TEST(PresentedPhase, WithoutDwellItWouldFlicker) {
    // The control: the same turns, each of them lasting for longer than calm takes, are all followed.
    std::vector<Followed::From> turns{{0, kCruise}};
    for (int n = 0; n < 10; ++n) turns.push_back({10 + 2.5 * n, n % 2 == 0 ? kApproachFinal : kCruise});
    Followed flight(turns);
    static_cast<void>(flight.until(40));
    EXPECT_EQ(flight.turns(), 10);
}

TEST(PresentedPhase, ATurnAwayFromTerrainInUnrestWaits) {
    Followed flight({{0, kCruise}, {10, kApproachFinal}, {10.5, kGoAroundReplanning}});
    EXPECT_EQ(flight.until(12.4).presented, kApproachFinal);
    EXPECT_EQ(flight.until(12.5).presented, kGoAroundReplanning) << "it has lasted two seconds";
}

TEST(PresentedPhase, TimeThatRunsBackBeginsAnew) {
    PresentedPhaseState state;
    PhaseStatus status;
    status.phase = kCruise;
    follow_phase(status, base::Time{10'000'000'000}, state);
    status.phase = kTakeoffStart;
    follow_phase(status, base::Time{1'000'000'000}, state);
    EXPECT_EQ(status.presented, kTakeoffStart);
    EXPECT_EQ(status.presented_since.ns, 1'000'000'000);
}

}  // namespace
}  // namespace tedavis::flight::test_presented_phase
