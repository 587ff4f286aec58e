#include "host_sim/accuracy/knobs/quality_level_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_quality_level_knob {
namespace {

/// A tenth is allowed against the order: the grain of the natural ground follows the pixel, so that colors of two levels of much
/// the same geometry differ from the design's by chance; detail alone changes nothing where no drawn element has less of it.
TEST(QualityLevelKnob, EveryLevelDepartsFartherFromTheDesign) {
    const test_support::ShippedKnobGround shipped;
    const auto knob = make_quality_level_knob(shipped.quick());
    const std::size_t whole = knob->facts().levels.size() - 1;
    std::vector<double> means;
    for (std::size_t level = 0; level <= whole; ++level) means.push_back(test_support::errors_of(*knob, level).mean);
    for (std::size_t level = 1; level <= whole; ++level) EXPECT_LT(means[level], 1.1 * means[level - 1]) << level;
    EXPECT_LT(means[whole - 1], means.front() / 2);
    EXPECT_EQ(test_support::errors_of(*knob, whole).max, 0) << "drawn again after all others, it has the same bits";
    EXPECT_GT(means.front(), 0.05) << "control: the cheapest is visibly another picture";
}

}  // namespace
}  // namespace tedavis::host_sim::test_quality_level_knob
