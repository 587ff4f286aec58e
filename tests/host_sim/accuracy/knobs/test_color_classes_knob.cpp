#include "host_sim/accuracy/knobs/color_classes_knob.hpp"

#include <gtest/gtest.h>

#include "render_core/design/data_scale.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_color_classes_knob {
namespace {

TEST(ColorClassesKnob, AValueIsOffByHalfAClassAtMost) {
    const test_support::MadeKnobGround made;
    const auto knob = make_color_classes_knob(made.quick());
    const design::Palette palette = design::alpine_palette();
    const double span = palette.stops.back().value - palette.stops[0].value;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level) {
        const double width = span / knob->facts().levels[level].amount;
        const ErrorDistribution errors = test_support::errors_of(*knob, level);
        EXPECT_LE(errors.max, width / 2 * (1 + 1e-12));
        EXPECT_GT(errors.max, 0.49 * width) << "control: the whole class is used";
        EXPECT_NEAR(errors.mean, width / 4, 0.01 * width);
    }
}

/// The colour of a class is that which the continuous palette has for the value that the knob reads back.
TEST(ColorClassesKnob, TheValueThatIsReadBackHasTheColorShown) {
    design::DataScale scale;
    scale.palette = design::alpine_palette();
    design::reduce_classes(scale, 8);
    const double low = scale.palette.stops[0].value, high = scale.palette.stops.back().value, width = (high - low) / 8;
    for (int number = 0; number < 8; ++number) {
        const double middle = low + (number + 0.5) * width;
        EXPECT_EQ(design::scale_color(scale, middle + 0.3 * width), design::color_of_value(scale.palette, middle));
    }
    EXPECT_NE(design::scale_color(scale, low), design::color_of_value(scale.palette, low)) << "control: not the value's own";
}

}  // namespace
}  // namespace tedavis::host_sim::test_color_classes_knob
