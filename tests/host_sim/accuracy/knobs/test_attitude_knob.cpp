#include "host_sim/accuracy/knobs/attitude_knob.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render_core/earth/wgs84.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::host_sim::test_attitude_knob {
namespace {

/// The body's axes in north, east and down by the product's own function: at latitude and longitude 0 its frame is exact.
glm::dmat3 axes_of(const Attitude& attitude) {
    return glm::transpose(earth::north_east_down(0, 0)) *
           earth::body_axes(0, 0, attitude.heading_rad, attitude.pitch_rad, attitude.roll_rad);
}

/// A share of the turn from one to the other about their common axis, which is that of the matrix of the turn (Rodrigues).
glm::dmat3 turned(const glm::dmat3& from, const glm::dmat3& to, double share) {
    const glm::dmat3 turn = to * glm::transpose(from);
    const glm::dvec3 twice(turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]);
    const double angle = std::atan2(glm::length(twice), turn[0][0] + turn[1][1] + turn[2][2] - 1) * share;
    const glm::dvec3 axis = glm::normalize(twice);
    glm::dmat3 made;
    for (int c = 0; c < 3; ++c)
        made[c] = std::cos(angle) * from[c] + std::sin(angle) * glm::cross(axis, from[c]) +
                  (1 - std::cos(angle)) * glm::dot(axis, from[c]) * axis;
    return made;
}

double difference(const glm::dmat3& a, const glm::dmat3& b) {
    double most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, glm::length(a[c] - b[c]));
    return most;
}

TEST(AttitudeKnob, TheReferenceTurnsAboutTheCommonAxis) {
    test_support::Dice dice(1);
    for (int n = 0; n < 2000; ++n) {
        const Attitude from{dice.between(-3, 3), dice.between(-1.4, 1.4), dice.between(-3, 3)};
        const Attitude to{from.heading_rad + dice.between(-1, 1), dice.between(-1.4, 1.4), from.roll_rad + dice.between(-1, 1)};
        const double share = dice.between(0, 1);
        const glm::dmat3 exact = axes_by_long_slerp(from, to, share);
        ASSERT_LT(difference(exact, turned(axes_of(from), axes_of(to), share)), 1e-13) << n;
        ASSERT_LT(difference(axes_by_long_slerp(from, to, 0), axes_of(from)), 1e-15);
        ASSERT_LT(difference(axes_by_long_slerp(from, to, 1), axes_of(to)), 1e-15);
    }
    const Attitude same{1, 0.2, 0.3};
    EXPECT_LT(difference(axes_by_long_slerp(same, same, 0.5), axes_of(same)), 1e-15) << "no turn";
}

TEST(AttitudeKnob, AnglesForThemselvesAreNotTheShortestTurn) {
    const test_support::MadeKnobGround made;
    const auto knob = make_attitude_between_knob(made.quick());
    ASSERT_TRUE(knob->facts().only_level.has_value());
    const ErrorDistribution angles = test_support::errors_of(*knob, 0), straight = test_support::errors_of(*knob, 1),
                            sphere = test_support::errors_of(*knob, 2);
    EXPECT_GT(angles.max, 1) << "control: they bank and turn otherwise";
    EXPECT_LT(angles.max, 30) << "but between the two attitudes";
    EXPECT_LT(straight.max, 0.2) << "an arc of up to 52 degrees";
    EXPECT_GT(straight.max, 1e-3) << "control: a chord is no arc";
    EXPECT_LT(sphere.max, 1e-12);
}

}  // namespace
}  // namespace tedavis::host_sim::test_attitude_knob
