#include "host_sim/accuracy/knobs/cap_overlap_knob.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_core/raytrace/shading/aperture_light.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::host_sim::test_cap_overlap_knob {
namespace {

/// Half of the angle of the ring at `from_centre` of the cap round which the rings lie that is within the other cap.
double half_arc_within(double radius, double distance, double from_centre) {
    const double cosine =
        (std::cos(radius) - std::cos(distance) * std::cos(from_centre)) / (std::sin(distance) * std::sin(from_centre));
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// The overlap by Simpson's rule over rings of the smaller cap; rings that are cut begin at |distance - larger|, where a root is
/// removed by squares of the step.
double overlap_by_rings(double larger, double smaller, double distance) {
    constexpr int kRings = 2000;
    const double first = std::abs(distance - larger), width = smaller - first;
    double sum = 0;
    for (int n = 0; n <= kRings; ++n) {
        const double s = n / double{kRings}, ring = first + width * s * s;
        const double value = n == 0 ? 0 : 2 * std::sin(ring) * half_arc_within(larger, distance, ring) * 2 * width * s;
        sum += value * (n == 0 || n == kRings ? 1 : n % 2 == 1 ? 4 : 2);
    }
    return (distance < larger ? raytrace::cap_area(first) : 0) + sum / (3 * kRings);
}

TEST(CapOverlapKnob, TheReferenceIsWithinItsBound) {
    const test_support::MadeKnobGround made;
    const double bound = make_cap_overlap_knob(made.quick())->facts().reference.error_bound();
    const double sun = raytrace::kSunRadius_rad;
    test_support::Dice dice(1);
    for (int n = 0; n < 2000; ++n) {
        const double aperture = dice.between(0.05, 1.55), distance = aperture + sun * dice.between(-0.998, 0.998);
        const double exact = overlap_by_arc_cosines(aperture, sun, distance) / raytrace::cap_area(sun);
        ASSERT_NEAR(overlap_by_rings(aperture, sun, distance) / raytrace::cap_area(sun), exact, bound)
            << aperture << ' ' << distance;
    }
}

TEST(CapOverlapKnob, TheSmoothstepIsOffAndTheExactFormIsNot) {
    const test_support::MadeKnobGround made;
    const auto knob = make_cap_overlap_knob(made.quick());
    const ErrorDistribution smooth = test_support::errors_of(*knob, 0), exact = test_support::errors_of(*knob, 1);
    EXPECT_LT(exact.max, 1e-4) << "what cap_overlap.hpp states";
    EXPECT_LT(smooth.max, 0.05) << "what cap_overlap.hpp states";
    EXPECT_GT(smooth.max, 0.01) << "control: it is an approximation";
    test_support::record_worst("A29", exact.max);
    test_support::record_control("A29", smooth.max);
}

}  // namespace
}  // namespace tedavis::host_sim::test_cap_overlap_knob
