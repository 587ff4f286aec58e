#include "host_sim/accuracy/knobs/depth_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_depth_knob {
namespace {

TEST(DepthKnob, TwoRangesTellWhatThePlanPromises) {
    const test_support::MadeKnobGround made;
    const auto knob = make_depth_format_knob(made.quick());
    ASSERT_TRUE(knob->facts().only_level.has_value());
    const ErrorDistribution planned = test_support::errors_of(*knob, 0), one = test_support::errors_of(*knob, 1),
                            coarse = test_support::errors_of(*knob, 2), logarithm = test_support::errors_of(*knob, 3),
                            reversed = test_support::errors_of(*knob, 4);
    constexpr double kPromised = 0.3, kStep = 1.19;  // m per km, depth_plan.hpp; of the gaps that are tried
    EXPECT_LT(planned.max, kPromised * kStep);
    EXPECT_GT(one.max, 10 * planned.max) << "control: one range does not tell far gaps";
    EXPECT_GE(coarse.max, 500) << "control: 16 bits tell nothing there";
    EXPECT_LT(logarithm.max, planned.max);
    EXPECT_LT(reversed.max, planned.max);
    EXPECT_GT(planned.max, 1e-3) << "control: the gap is found, not the smallest that is tried";
}

}  // namespace
}  // namespace tedavis::host_sim::test_depth_knob
