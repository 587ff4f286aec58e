#include "host_sim/accuracy/flight_errors.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_flight_errors {
namespace {

TEST(FlightErrors, NeverExceedWhatWasProven) {
    const test_support::MadeKnobGround made;
    FlightErrorsPlan plan;
    plan.moments = 3;
    plan.line_poses = 2;
    std::size_t calls = 0;
    plan.progress = [&](std::size_t done, std::size_t total) {
        EXPECT_LT(done, total);
        ++calls;
    };
    const FlightErrors errors = measure_flight_errors(made.quick(), plan);
    EXPECT_GE(calls, errors.moments.size() + errors.lines.size());
    EXPECT_LE(calls, plan.moments + plan.line_poses * errors.lines.size()) << "one for each frame";
    EXPECT_TRUE(errors.holds());
    ASSERT_GE(errors.moments.size(), 2u) << "a pose that shows no ground is left out";
    for (const MeasuredMoment& moment : errors.moments) {
        EXPECT_GT(moment.samples, 0u);
        EXPECT_LE(moment.proven_px, errors.asked_px);
        EXPECT_LE(moment.measured_px, moment.proven_px + 0.01);
    }
    const ToleranceLine &coarse = errors.lines.front(), &fine = errors.lines.back();
    EXPECT_GT(coarse.asked_px, fine.asked_px);
    EXPECT_GT(coarse.measured_px, fine.measured_px) << "control: the samples see the error";
    for (const ToleranceLine& line : errors.lines) EXPECT_LE(line.proven_px, line.asked_px);
    EXPECT_GT(coarse.tightness.max, 0.1) << "the bound is not much larger than the error";
    EXPECT_LE(coarse.tightness.max, 1);
    EXPECT_LE(coarse.tightness.median, coarse.tightness.max);
}

TEST(FlightErrors, HaveMoreSamplesOfAFrameWhereMorePlacesAreAskedFor) {
    const test_support::MadeKnobGround made;
    FlightErrorsPlan plan;
    plan.moments = plan.line_poses = 2;
    plan.progress = [](std::size_t, std::size_t) {};
    const FlightErrors few = measure_flight_errors(made.quick(), plan);
    plan.across = 2 * SeenGrid().across;
    const FlightErrors many = measure_flight_errors(made.quick(), plan);
    EXPECT_NEAR(static_cast<double>(many.samples()) / static_cast<double>(few.samples()), 4, 0.4);
    EXPECT_TRUE(many.holds());
}

TEST(FlightErrors, AreThoseOfARecordedFlight) {
    const test_support::MadeKnobGround made;
    std::ostringstream results, notes;
    Console console{results, notes, true, false};
    const RecordedPoses recorded =
        read_recorded_poses({made.files.log, "canaerospace", "", "one_hot"}, made.files.terrain, console);
    KnobGround ground = made.quick();
    ground.recorded = &recorded;
    FlightErrorsPlan plan;
    plan.moments = 4;
    plan.line_poses = 2;
    plan.progress = [](std::size_t, std::size_t) {};
    const FlightErrors errors = measure_flight_errors(ground, plan);
    EXPECT_EQ(errors.flight, made.files.log);
    EXPECT_EQ(errors.identity, recorded.identity);
    EXPECT_EQ(errors_over(ground, {FlightErrors(), errors})->flight, errors.flight);
    FlightErrors of_other_heights = errors;
    ++of_other_heights.terrain_identity;
    EXPECT_EQ(errors_over(ground, {FlightErrors(), of_other_heights}), nullptr);
    const std::vector<KnobGround> twice{ground, ground};
    EXPECT_EQ(errors_over(twice, {FlightErrors(), errors, of_other_heights}).size(), 1u)
        << "once, and none that was not asked for";
    EXPECT_TRUE(errors_over(twice, {of_other_heights}).empty());
    EXPECT_TRUE(errors.holds());
    ASSERT_EQ(errors.moments.size(), 4u);
    for (const MeasuredMoment& moment : errors.moments) EXPECT_EQ(moment.pose.substr(0, 4), "47.0") << "where it was flown";
    EXPECT_GT(errors.moments.back().time_s, 5);
    EXPECT_LT(errors.moments.back().time_s, 8);
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_errors
