#include "host_sim/evaluation/flight_comparison.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flight_comparison {
namespace {

TEST(FlightComparison, PairsFramesOfTheSameTime) {
    const EvaluatedFlight a = test_support::made_flight(30, 0.1);
    EvaluatedFlight b = test_support::made_flight(30, 0.15);
    b.run.frames.erase(b.run.frames.begin(), b.run.frames.begin() + 2);
    b.measures.erase(b.measures.begin(), b.measures.begin() + 2);
    b.run.frames[5].time_s += 0.5;
    b.run.frames[6].time_s += 1e-5;  // as two clocks round
    const FlightComparison comparison = compared(a, b);
    EXPECT_EQ(comparison.pairs.size(), 27u);
    EXPECT_EQ(comparison.only_a, 3u);
    EXPECT_EQ(comparison.only_b, 1u);
    ASSERT_EQ(comparison.phases.size(), 2u);
    EXPECT_EQ(comparison.phases[0].frames + comparison.phases[1].frames, 27u);
    EXPECT_NEAR(comparison.all.mean_b - comparison.all.mean_a, 0.05, 1e-12);
    EXPECT_NEAR(comparison.all.highest_b - comparison.all.highest_a, 0.05, 1e-12);
    EXPECT_EQ(comparison.all.begin_s, 2);
    EXPECT_EQ(frame_nearest(a, 7.4), 7u);
    EXPECT_EQ(frame_nearest(a, 1e9), 29u);
}

TEST(FlightComparison, ARunAgainstItselfDiffersNowhere) {
    const EvaluatedFlight a = test_support::made_flight(30);
    for (const PhaseDifference& one : compared(a, a).phases) EXPECT_EQ(one.mean_a, one.mean_b);
}

TEST(FlightComparison, NamesAreTheDesignsWhereTheyDiffer) {
    const EvaluatedFlight a = test_support::made_flight(9);
    EvaluatedFlight b = a;
    b.run.folder = "other";
    EXPECT_EQ(compared(a, b).name_b, "other");
    b.run.design = "cruise";
    EXPECT_EQ(compared(a, b).name_a, "default");
    EXPECT_EQ(compared(a, b).name_b, "cruise");
}

TEST(FlightComparison, AnotherFlightIsRefused) {
    const EvaluatedFlight a = test_support::made_flight(9);
    EvaluatedFlight b = a;
    for (FlightFrame& frame : b.run.frames) frame.time_s += 0.5;
    test_support::expect_user_error([&] { (void)compared(a, b); }, "replay the same log");
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_comparison
