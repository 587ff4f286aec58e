#include "host_sim/accuracy/knobs/perception_knobs.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_perception_knobs {
namespace {

TEST(PerceptionKnobs, ASmallerStartOfSaliencyIsFartherOffAndTakesLessMemory) {
    const test_support::MadeKnobGround made;
    const auto knob = make_saliency_start_knob(made.quick());
    const double quarter = test_support::errors_of(*knob, 0).mean, half = test_support::errors_of(*knob, 1).mean;
    EXPECT_GT(quarter, 1.5 * half);
    EXPECT_GT(half, 0) << "control: half of the size is not the reference";
    EXPECT_EQ(test_support::errors_of(*knob, 2).max, 0);
    EXPECT_LT(knob->bytes(0), knob->bytes(2));
}

TEST(PerceptionKnobs, EdgesAtASmallerSizeAreFartherOff) {
    const test_support::MadeKnobGround made;
    const auto knob = make_edge_size_knob(made.quick());
    const double quarter = test_support::errors_of(*knob, 0).mean, half = test_support::errors_of(*knob, 1).mean;
    EXPECT_GT(quarter, half);
    EXPECT_GT(half, 0) << "control: half of the size is not the reference";
    EXPECT_EQ(test_support::errors_of(*knob, 2).max, 0);
    EXPECT_EQ(test_support::errors_of(*knob, 0).count, 48u) << "regions of a picture";
}

}  // namespace
}  // namespace tedavis::host_sim::test_perception_knobs
