#include "render_core/perception/oriented_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/render_core/perception/held_plane.hpp"

namespace tedavis::perception::test_oriented_energy {
namespace {

using test_support::HeldPlane;
using test_support::noise_plane;

struct Answers {
    explicit Answers(const Plane& plane) {
        std::array<Plane, kDirections> out;
        for (std::size_t k = 0; k < kDirections; ++k) {
            held.emplace_back(plane.width, plane.height);
            out[k] = held[k].plane;
        }
        std::vector<float> scratch(kOrientedEnergyScratch);
        oriented_energy(plane, gabor_taps(), out, scratch);
    }
    std::vector<HeldPlane> held;
};

constexpr double kPi = 3.14159265358979323846;

TEST(OrientedEnergy, IsTheDirectSumOfProducts) {
    const std::pair<int, int> sizes[] = {{1, 1}, {2, 3}, {5, 1}, {23, 17}, {128, 9}, {300, 12}};
    for (const auto& [width, height] : sizes) {
        const HeldPlane plane = noise_plane(width, height, 3);
        const Answers answers(plane.plane);
        for (std::size_t k = 0; k < kDirections; ++k) {
            const test_support::Field expected = test_support::reference_gabor(plane.field(), static_cast<double>(k) * kPi / 4);
            for (std::size_t n = 0; n < expected.values.size(); ++n)
                ASSERT_NEAR(answers.held[k].values[n], expected.values[n], 1e-5) << width << ' ' << k;
        }
    }
}

TEST(OrientedEnergy, AGratingAnswersInItsDirection) {
    for (std::size_t direction = 0; direction < kDirections; ++direction) {
        const double angle = static_cast<double>(direction) * kPi / 4;
        HeldPlane grating(40, 40);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                grating.plane.row(y)[x] = static_cast<float>(
                    0.5 + 0.5 * std::cos(2 * kPi / kGaborWave_px * (x * std::cos(angle) + y * std::sin(angle)) + 0.3));
        const Answers answers(grating.plane);
        for (std::size_t k = 0; k < kDirections; ++k) {
            const float middle = answers.held[k].plane.row(20)[20];
            if (k == direction)
                EXPECT_NEAR(middle, 1, 0.05) << k;
            else
                EXPECT_LT(middle, 0.4) << k << " of " << direction;
        }
    }
}

TEST(OrientedEnergy, WhatIsFlatHasNone) {
    const Answers answers(HeldPlane(30, 20, 0.8f).plane);
    for (const HeldPlane& held : answers.held)
        for (const float value : held.values) EXPECT_LT(value, 1e-5f);
}

}  // namespace
}  // namespace tedavis::perception::test_oriented_energy
