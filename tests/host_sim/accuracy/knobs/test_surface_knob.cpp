#include "host_sim/accuracy/knobs/surface_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_surface_knob {
namespace {

TEST(SurfaceKnob, MoreSubdivisionsComeCloserToTheSmoothSurface) {
    const test_support::MadeKnobGround made;
    const auto knob = make_surface_knob(made.quick());
    const std::size_t levels = knob->facts().levels.size();
    std::vector<double> means;
    for (std::size_t level = 0; level < levels; ++level) {
        means.push_back(test_support::errors_of(*knob, level).mean);
        EXPECT_GT(knob->bytes(level), 0u);
    }
    for (std::size_t level = 1; level < levels; ++level) EXPECT_LT(means[level], 0.5 * means[level - 1]) << level;
    EXPECT_EQ(means.back(), 0) << "the smooth surface itself";
    EXPECT_GT(means.front(), 0) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_surface_knob
