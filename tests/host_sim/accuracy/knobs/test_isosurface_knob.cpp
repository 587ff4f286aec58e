#include "host_sim/accuracy/knobs/isosurface_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_isosurface_knob {
namespace {

TEST(IsosurfaceKnob, ErrorsFallWithTheSquareOfTheStep) {
    const test_support::MadeKnobGround made;
    const auto knob = make_isosurface_step_knob(made.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, 2, 0.3);
    const ErrorDistribution finest = test_support::errors_of(*knob, 3), coarsest = test_support::errors_of(*knob, 0);
    EXPECT_GT(finest.max, 10 * knob->facts().reference.error_bound());
    EXPECT_LT(finest.max, 300) << "less than a post's spacing";
    EXPECT_GT(coarsest.max, 300) << "control: a step of 8 posts is visibly wrong";
    EXPECT_GT(finest.count, 4 * coarsest.count) << "a finer surface has more triangles";
}

TEST(IsosurfaceKnob, MemoryIsThatOfThePostsUsed) {
    const test_support::MadeKnobGround made;
    const auto knob = make_isosurface_step_knob(made.quick());
    EXPECT_EQ(knob->bytes(3), 65u * 65 * 65 * 4);
    EXPECT_EQ(knob->bytes(0), 9u * 9 * 9 * 4);
}

}  // namespace
}  // namespace tedavis::host_sim::test_isosurface_knob
