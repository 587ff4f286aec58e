#include "host_sim/accuracy/knobs/label_places_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_label_places_knob {
namespace {

TEST(LabelPlacesKnob, MorePlacesLeaveFewerNamesOut) {
    const test_support::MadeKnobGround made;
    const auto knob = make_label_places_knob(made.quick());
    std::vector<double> means;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level)
        means.push_back(test_support::errors_of(*knob, level).mean);
    for (std::size_t level = 1; level < means.size(); ++level) EXPECT_LE(means[level], means[level - 1]) << level;
    EXPECT_LT(means.back(), 0.8 * means.front());
    EXPECT_GT(means.back(), 0) << "control: the best first is not the best of all";
}

}  // namespace
}  // namespace tedavis::host_sim::test_label_places_knob
