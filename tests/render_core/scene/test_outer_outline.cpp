#include "render_core/scene/outer_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/scene/polygon_triangles.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::scene::test_outer_outline {
namespace {

using Corners = std::vector<glm::dvec2>;

Corners simpler(Corners corners, double most_growth) {
    corners.resize(simplify_outwards({corners.data(), corners.size()}, most_growth));
    return corners;
}

double area(const Corners& corners) { return std::fabs(0.5 * twice_area({corners.data(), corners.size()})); }

/// By the angles under which the corners are seen from there: round once where the outline goes round it, whatever its shape.
bool goes_round(const Corners& corners, const glm::dvec2& p) {
    double angle = 0;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const glm::dvec2 a = corners[n] - p, b = corners[(n + 1) % corners.size()] - p;
        angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    }
    return std::fabs(angle) > base::kPi;
}

/// Round a middle, its distances from there any: never crosses itself, and bends both ways.
Corners ragged(unsigned seed, std::size_t count, bool clockwise) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distance(300, 1000);
    Corners corners;
    for (std::size_t n = 0; n < count; ++n) {
        const double turn = (clockwise ? -1 : 1) * 2 * base::kPi * static_cast<double>(n) / static_cast<double>(count);
        const double far = distance(random);
        corners.push_back({far * std::cos(turn) + 5000, far * std::sin(turn) - 200});
    }
    return corners;
}

/// Places of the true outline and a little inside it.
std::size_t lost_places(const Corners& truth, const Corners& drawn) {
    std::size_t lost = 0;
    for (std::size_t n = 0; n < truth.size(); ++n)
        for (double share = 0; share < 1; share += 0.125) {
            const glm::dvec2 on_side = truth[n] + (truth[(n + 1) % truth.size()] - truth[n]) * share;
            const glm::dvec2 inwards = on_side + (glm::dvec2(5000, -200) - on_side) * 1e-6;
            lost += goes_round(drawn, inwards) ? 0 : 1;
        }
    return lost;
}

TEST(OuterOutline, ContainsTheTrueOneAndGrowsNoMoreThanAllowed) {
    std::size_t worst = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Corners truth = ragged(seed, 24 + seed, seed % 2 == 1);
        std::size_t before = truth.size();
        for (const double growth : {0.05, 0.1, 0.2, 0.4}) {
            const Corners drawn = simpler(truth, growth);
            const std::size_t lost = lost_places(truth, drawn);
            EXPECT_EQ(lost, 0u) << seed << " " << growth;
            worst = std::max(worst, lost);
            EXPECT_LE(area(drawn), (1 + growth) * area(truth) * (1 + 1e-12));
            EXPECT_GE(area(drawn), area(truth) * (1 - 1e-12));
            EXPECT_LE(drawn.size(), before + 2) << "about fewer the more it may grow";
            before = drawn.size();
        }
        EXPECT_LT(before, truth.size() * 3 / 4);
    }
    test_support::record_worst("A68", static_cast<double>(worst));
}

/// Control: what leaves out every other corner, as a simplification of lines does, loses places.
TEST(OuterOutline, EveryOtherCornerWouldNotContainIt) {
    const Corners truth = ragged(1, 40, false);
    Corners other;
    for (std::size_t n = 0; n < truth.size(); n += 2) other.push_back(truth[n]);
    const std::size_t lost = lost_places(truth, other);
    EXPECT_GT(lost, 0u);
    test_support::record_control("A68", static_cast<double>(lost));
}

TEST(OuterOutline, ACircleBecomesABoxAndANotchIsFilled) {
    Corners circle;
    for (int n = 0; n < 64; ++n) circle.push_back({std::cos(2 * base::kPi * n / 64), std::sin(2 * base::kPi * n / 64)});
    const Corners box = simpler(circle, 0.5);
    EXPECT_LE(box.size(), 6u) << "a square round a circle is 27 % larger";
    const Corners notched{{0, 0}, {10, 0}, {10, 10}, {6, 10}, {5, 5}, {4, 10}, {0, 10}};
    const Corners filled = simpler(notched, 0.2);
    EXPECT_EQ(filled.size(), 4u);
    EXPECT_DOUBLE_EQ(area(filled), 100);
}

TEST(OuterOutline, WhatMayNotGrowOrCrossesItselfStays) {
    const Corners truth = ragged(7, 30, false);
    EXPECT_EQ(simpler(truth, 0), truth);
    const Corners bow{{0, 0}, {10, 10}, {10, 0}, {0, 10}, {-3, 5}};
    EXPECT_EQ(simpler(bow, 0.5), bow);
    const Corners box{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    EXPECT_EQ(simpler(box, 0.5), box);
}

/// Between the arms of a U there may be something else: neither arm may grow through the other.
TEST(OuterOutline, NeverCrossesItself) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Corners drawn = simpler(ragged(seed, 50, false), 0.3);
        const Corners again = simpler(drawn, 1e-9);
        for (std::size_t n = 0; n < drawn.size(); ++n)
            for (std::size_t m = n + 2; m < drawn.size(); ++m) {
                if ((m + 1) % drawn.size() == n) continue;
                const auto side = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
                    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                };
                const glm::dvec2 &a = drawn[n], &b = drawn[(n + 1) % drawn.size()];
                const glm::dvec2 &c = drawn[m], &d = drawn[(m + 1) % drawn.size()];
                EXPECT_FALSE(side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) << seed;
            }
        EXPECT_LE(again.size(), drawn.size());
    }
}

}  // namespace
}  // namespace tedavis::scene::test_outer_outline
