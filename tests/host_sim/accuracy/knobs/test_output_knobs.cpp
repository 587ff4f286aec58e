#include "host_sim/accuracy/knobs/output_knobs.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_output_knobs {
namespace {

TEST(OutputKnobs, ASmallerPictureIsFartherFromTheWindow) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_picture_size_knob(shipped.quick());
    const std::size_t full = knob->facts().levels.size() - 1;
    std::vector<double> means;
    for (std::size_t level = 0; level <= full; ++level) means.push_back(test_support::errors_of(*knob, level).mean);
    for (std::size_t level = 1; level <= full; ++level) EXPECT_LT(means[level], means[level - 1]) << level;
    EXPECT_EQ(means[full], 0);
    EXPECT_GT(means[full - 1], 0.1) << "control: three quarters of the size are not all of it";
    EXPECT_EQ(knob->bytes(0), 160u * 90 * 4);
}

/// Half as many pictures stand twice as long, in which the ground moves twice as far.
TEST(OutputKnobs, TheLagOfAPictureIsAsLongAsItStands) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_output_rate_knob(shipped.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, -1, 0.05);
    const ErrorDistribution slow = test_support::errors_of(*knob, 0), fast = test_support::errors_of(*knob, 4);
    EXPECT_GT(slow.mean, 0.5) << "control: at 5 pictures a second they lag visibly";
    EXPECT_GT(fast.mean, 5 * knob->facts().reference.error_bound());
}

}  // namespace
}  // namespace tedavis::host_sim::test_output_knobs
