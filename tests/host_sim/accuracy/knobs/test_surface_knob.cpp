#include "host_sim/accuracy/knobs/surface_knob.hpp"

#include <gtest/gtest.h>

#include "host_sim/accuracy/statistics.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_surface_knob {
namespace {

TEST(SurfaceKnob, MoreSubdivisionsComeCloserToTheSmoothSurface) {
    const test_support::FlownFiles files;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    const auto knob = make_surface_knob({ground, true});
    const std::size_t levels = knob->facts().levels.size();
    std::vector<double> means;
    for (std::size_t level = 0; level < levels; ++level) {
        std::vector<double> errors;
        for (std::size_t sample = 0; sample < knob->samples(); ++sample) knob->find_errors(level, sample, errors);
        means.push_back(distribution_of(errors).mean);
        EXPECT_GT(knob->bytes(level), 0u);
    }
    for (std::size_t level = 1; level < levels; ++level) EXPECT_LT(means[level], 0.5 * means[level - 1]) << level;
    EXPECT_EQ(means.back(), 0) << "the smooth surface itself";
    EXPECT_GT(means.front(), 0) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_surface_knob
