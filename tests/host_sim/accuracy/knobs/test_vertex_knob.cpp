#include "host_sim/accuracy/knobs/vertex_knob.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_vertex_knob {
namespace {

TEST(VertexKnob, OneSumOfFloatsIsEnoughAndEcefIsNot) {
    const test_support::MadeKnobGround made;
    const auto knob = make_vertex_precision_knob(made.quick());
    ASSERT_TRUE(knob->facts().only_level.has_value());
    const ErrorDistribution ours = test_support::errors_of(*knob, 0), ecef = test_support::errors_of(*knob, 1),
                            pairs = test_support::errors_of(*knob, 2), doubles = test_support::errors_of(*knob, 3);
    EXPECT_LT(ours.max, 0.1) << "px, a tenth of what anything else may be off";
    EXPECT_GT(ecef.max, 10) << "control: near vertices jump by many pixels";
    EXPECT_LT(pairs.max, ours.max);
    EXPECT_GT(pairs.max, 10 * knob->facts().reference.error_bound()) << "the reference can tell";
    EXPECT_LT(doubles.max, 1e-6);
}

/// By hand: a float of ECEF is half a metre coarse, or a quarter; seen from 10 to 20 m that is up to 1662 px times 0.43 m by 10
/// m.
TEST(VertexKnob, WhatAFloatOfEcefLosesIsWhatIsSeen) {
    const test_support::MadeKnobGround made;
    const auto knob = make_vertex_precision_knob(made.quick());
    const double focal_px = 960 / std::tan(3.14159265358979 / 6);
    for (std::size_t sample = 0; sample < knob->samples(); ++sample) {
        std::vector<double> errors;
        knob->find_errors(1, sample, errors);
        for (std::size_t n = 0; n < errors.size(); ++n) {
            double away_m = 0;
            const std::string place = knob->place_of(sample, n);
            ASSERT_EQ(std::sscanf(place.c_str(), "view %*u, a vertex %lf m away", &away_m), 1) << place;
            if (away_m < 100) continue;  // farther away the matrix' own floats, of up to 0.5 m too, are as small
            EXPECT_LT(errors[n], 1.5 * focal_px * 4 / away_m) << place;
        }
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_vertex_knob
