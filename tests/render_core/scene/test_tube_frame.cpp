#include "render_core/scene/tube_frame.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "render_core/base/units.hpp"
#include "tests/render_core/scene/curve_frames.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::scene::test_tube_frame {
namespace {

using base::kPi;
using test_support::is_orthonormal;
using test_support::KnotCurve;

const glm::dvec3 kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

/// The naive form: the last normal, projected onto the plane across the next tangent.
TubeFrame projected(const TubeFrame& last, const glm::dvec3&, const glm::dvec3& tangent) {
    return {tangent, glm::normalize(last.normal - glm::dot(last.normal, tangent) * tangent)};
}

using Carry = TubeFrame (*)(const TubeFrame& last, const glm::dvec3& step, const glm::dvec3& tangent);

double end_error_rad(int segments, Carry carry = carried) {
    const KnotCurve curve;
    const double end = 2 * kPi * 0.9;
    TubeFrame frame{curve.tangent(0), normal_towards(kZ, curve.tangent(0))};
    const glm::dvec3 truth = test_support::integrated_normal(curve, frame.normal, end, 100 * segments);
    for (int n = 0; n < segments; ++n) {
        const double u = end * n / segments, next = end * (n + 1) / segments;
        frame = carry(frame, curve.at(next) - curve.at(u), curve.tangent(next));
    }
    return std::atan2(glm::length(glm::cross(frame.normal, truth)), glm::dot(frame.normal, truth));
}

TEST(TubeFrame, ErrorAgainstTheDifferentialEquationIsOfFourthOrder) {
    double last = end_error_rad(40);
    EXPECT_LT(last, 0.05);
    for (const int segments : {80, 160, 320}) {
        const double error = end_error_rad(segments);
        EXPECT_NEAR(std::log2(last / error), 4, 0.35) << segments << " segments: " << error;
        last = error;
    }
}

/// Ours and the naive one at as many segments: projection is of first order and far off where tubes have few segments.
TEST(TubeFrame, ProjectedNormalsAreFarOff) {
    const double ours = end_error_rad(40), naive = end_error_rad(40, projected);
    EXPECT_LT(ours, 0.05);
    EXPECT_GT(naive, 0.05) << "control";
    EXPECT_NEAR(std::log2(end_error_rad(1280, projected) / end_error_rad(2560, projected)), 1, 0.35);
    test_support::record_worst("A34", ours);
    test_support::record_control("A34", naive);
}

TEST(TubeFrame, TheEquationsOwnErrorIsFarBelowWhatItJudges) {
    const KnotCurve curve;
    const glm::dvec3 begin = normal_towards(kZ, curve.tangent(0));
    const glm::dvec3 coarse = test_support::integrated_normal(curve, begin, 5, 16000);
    const glm::dvec3 fine = test_support::integrated_normal(curve, begin, 5, 32000);
    EXPECT_LT(glm::length(coarse - fine), 1e-11);
    EXPECT_LT(std::abs(glm::dot(fine, curve.tangent(5))), 1e-11);
}

TEST(TubeFrame, StraightStepsKeepTheNormal) {
    const TubeFrame frame = carried({kX, kZ}, 7.0 * kX, kX);
    EXPECT_LT(glm::length(frame.normal - kZ), 1e-15);
}

TEST(TubeFrame, ATurnInAPlaneTurnsTheNormalInItAndKeepsTheOneAcross) {
    const glm::dvec3 to = glm::normalize(kX + kY), step = glm::normalize(to + kX);
    EXPECT_LT(glm::length(carried({kX, kZ}, step, to).normal - kZ), 1e-15);
    EXPECT_LT(glm::length(carried({kX, kY}, step, to).normal - glm::normalize(kY - kX)), 1e-15);
}

TEST(TubeFrame, TurnedRoundItIsAHalfTurnAboutTheNormal) {
    for (const glm::dvec3& step : {kX, -kX, kY, glm::dvec3(0)}) {
        const TubeFrame frame = carried({kX, kZ}, step, -kX);
        EXPECT_TRUE(is_orthonormal(frame));
        EXPECT_LT(glm::length(frame.normal - kZ), 1e-15);
    }
}

TEST(TubeFrame, FramesStayOrthonormalWhateverTheStep) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    TubeFrame frame{kX, kZ};
    const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    for (int n = 0; n < 20000; ++n) {
        const glm::dvec3 to = n % 3 == 0 ? -frame.tangent : n % 3 == 1 ? frame.tangent : glm::normalize(vector());
        const glm::dvec3 step = n % 5 == 0 ? glm::dvec3(0) : n % 5 == 1 ? frame.tangent : vector();
        frame = carried(frame, step, to);
        ASSERT_TRUE(is_orthonormal(frame)) << n;
        ASSERT_LT(std::abs(glm::dot(frame.tangent, frame.normal)), 1e-12);
    }
}

TEST(TubeFrame, ANormalIsTheNearestToWhatIsWanted) {
    EXPECT_LT(glm::length(normal_towards({3, 0, 4}, kX) - kZ), 1e-15);
    for (const glm::dvec3& wanted : {glm::dvec3(0), 5.0 * kX, -kX, glm::dvec3(1, 1e-9, 0)})
        EXPECT_EQ(normal_towards(wanted, kX), kZ) << "nothing to go by";
    EXPECT_EQ(normal_towards(kZ, kZ), kX);
    EXPECT_EQ(normal_towards(kY * std::numeric_limits<double>::quiet_NaN(), kY), kZ);
}

}  // namespace
}  // namespace tedavis::scene::test_tube_frame
