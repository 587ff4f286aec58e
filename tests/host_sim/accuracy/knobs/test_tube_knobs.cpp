#include "host_sim/accuracy/knobs/tube_knobs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_tube_knobs {
namespace {

TEST(TubeKnobs, TheSagOfASideIsTheClosedForm) {
    const test_support::MadeKnobGround made;
    const auto knob = make_tube_sides_knob(made.quick());
    const double bound = knob->facts().reference.error_bound();
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level) {
        const double sag_m = 40 * (1 - std::cos(base::kPi / knob->facts().levels[level].amount));
        for (const double error : test_support::all_errors(*knob, level)) ASSERT_NEAR(error, sag_m, bound) << level;
        EXPECT_GT(sag_m, 10 * bound) << "control: the bound does not hide the sag";
    }
}

TEST(TubeKnobs, NoPointIsFartherFromTheTubeThanItsTolerance) {
    const test_support::MadeKnobGround made;
    const auto knob = make_tube_points_knob(made.quick());
    double tolerance_m = 400;
    for (std::size_t level = 0; level < knob->facts().levels.size(); ++level, tolerance_m /= std::sqrt(10.0)) {
        constexpr double kSagBetweenPoints_m = 3;  // 60 m apart, where the flight turns most
        const double worst_m = test_support::errors_of(*knob, level).max;
        EXPECT_LT(worst_m, tolerance_m + kSagBetweenPoints_m) << level;
        EXPECT_GT(worst_m, 0.3 * tolerance_m) << "control: the tolerance is used, level " << level;
    }
}

TEST(TubeKnobs, ErrorsFallWithTheSquareOfThePoints) {
    const test_support::MadeKnobGround made;
    const auto knob = make_tube_points_knob(made.quick());
    const FittedLaw law = test_support::law_of(*knob);
    EXPECT_TRUE(law.holds);
    EXPECT_NEAR(law.exponent, knob->facts().law->exponent, knob->facts().law->tolerance);
    EXPECT_GT(knob->facts().levels.back().amount, 2 * knob->facts().levels.front().amount) << "control: more points are kept";
}

}  // namespace
}  // namespace tedavis::host_sim::test_tube_knobs
