#include "host_sim/evaluation/evaluate_flight.hpp"

#include <gtest/gtest.h>

#include "host_sim/evaluation/evaluation_files.hpp"
#include "tests/host_sim/evaluation/evaluation_work.hpp"
#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_evaluate_flight {
namespace {

class EvaluateFlight : public ::testing::Test {
protected:
    EvaluateFlight() { test_support::write_striped_run(place_, "run", 12, {3, 8}); }
    [[nodiscard]] FlightRun run() const { return read_flight_run(place_.file("run")); }
    test_support::TemporaryFolder place_;
};

TEST_F(EvaluateFlight, EveryFrameHasItsOwnMeasures) {
    test_support::TestWork one(1);
    const EvaluatedFlight flight = measure_flight(run(), nullptr, one.work());
    ASSERT_EQ(flight.measures.size(), 12u);
    EXPECT_FALSE(flight.interrupted);
    for (std::size_t n = 0; n < 12; ++n) {
        const bool is_busy = n == 3 || n == 8;
        EXPECT_EQ(flight.measures[n].clutter > flight.measures[0].clutter, is_busy) << n;
    }
    const std::vector<FlightMoment> moments = moments_of(flight, "");
    ASSERT_EQ(moments.size(), 2u);
    EXPECT_EQ(moments[0].index, 3u);
    EXPECT_EQ(moments[1].index, 8u);
}

TEST_F(EvaluateFlight, ThreadsDoNotChangeABit) {
    test_support::TestWork one(1), three(3);
    const EvaluatedFlight a = measure_flight(run(), nullptr, one.work()), b = measure_flight(run(), nullptr, three.work());
    ASSERT_EQ(a.measures.size(), b.measures.size());
    for (std::size_t n = 0; n < a.measures.size(); ++n) {
        EXPECT_EQ(a.measures[n].clutter, b.measures[n].clutter);
        EXPECT_EQ(a.measures[n].clutter_grid, b.measures[n].clutter_grid);
        EXPECT_EQ(a.measures[n].saliency_level, b.measures[n].saliency_level);
    }
}

TEST_F(EvaluateFlight, WhatWasMeasuredBeforeAnInterruptStays) {
    test_support::TestWork stopped(1, 5), at_once(2, 0);
    const EvaluatedFlight flight = measure_flight(run(), nullptr, stopped.work());
    EXPECT_TRUE(flight.interrupted);
    EXPECT_EQ(flight.measures.size(), 5u);
    EXPECT_EQ(flight.run.frames.size(), 5u);
    EXPECT_THROW((void)measure_flight(run(), nullptr, at_once.work()), Interrupted);
}

TEST_F(EvaluateFlight, MomentsGetViewsAndPlan) {
    test_support::TestWork work(2);
    const EvaluatedFlight flight = measure_flight(run(), nullptr, work.work());
    PlanLines plan;
    MomentViews views;
    ClutterOpinions opinions;
    draw_moments({{&flight, 3, "A", "A: title", &plan, &views, &opinions}}, place_.path(), work.work());
    EXPECT_FALSE(plan.empty());
    EXPECT_FALSE(views.picture.empty() || views.saliency.empty() || views.heat.empty() || views.edges.empty() ||
                 views.congestion.empty());
    EXPECT_GT(opinions.feature_congestion, 0);
    EXPECT_GT(opinions.subband_entropy, 0);
    EXPECT_TRUE(std::filesystem::exists(view_files(place_.file("A")).sheet));
}

TEST_F(EvaluateFlight, GazeBelongsToTheFrameThatStood) {
    const std::string path = place_.write("gaze.csv", "time_s,x,y\n3.0,1,1\n3.9,2,2\n11.5,3,3\n-0.1,4,4\n12.5,5,5\n");
    const FixationFile file = read_fixations(path);
    const auto gaze = gaze_of_flight(file, run());
    EXPECT_EQ(gaze[3].size(), 2u);
    EXPECT_EQ(gaze[11].size(), 1u);
    std::size_t count = 0;
    for (const auto& frame : gaze) count += frame.size();
    EXPECT_EQ(count, 3u) << "two lie before and behind the flight";
    test_support::TestWork work;
    const EvaluatedFlight flight = measure_flight(run(), &file, work.work());
    EXPECT_TRUE(flight.measures[3].gaze.has_value());
    EXPECT_FALSE(flight.measures[4].gaze.has_value());
    const FixationFile timeless = read_fixations(place_.write("timeless.csv", "x,y\n1,1\n"));
    test_support::expect_user_error([&] { (void)gaze_of_flight(timeless, run()); }, "no column time_s");
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluate_flight
