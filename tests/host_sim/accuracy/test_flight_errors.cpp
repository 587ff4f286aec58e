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
    const FlightErrors errors = measure_flight_errors(made.ground, KnobFlight(made.ground), plan);
    EXPECT_EQ(calls, errors.moments.size() + errors.lines.size());
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
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_errors
