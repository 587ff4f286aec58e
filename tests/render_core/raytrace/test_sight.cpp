#include "render_core/raytrace/sight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/held_heights.hpp"
#include "tests/support/traced_ground.hpp"

namespace tedavis::raytrace {
namespace {

using Ground = test_support::TracedGround<std::int16_t>;

/// Height of the two triangles of a cell, or of its patch, written anew.
double height_of(const Ground& ground, CellSurface surface, double x, double y) {
    const auto column = std::min(static_cast<std::uint32_t>(x), ground.field.columns - 2);
    const auto row = std::min(static_cast<std::uint32_t>(y), ground.field.rows - 2);
    const double u = x - column, v = y - row;
    const double a = ground.field.at(column, row), b = ground.field.at(column + 1, row);
    const double c = ground.field.at(column, row + 1), d = ground.field.at(column + 1, row + 1);
    if (surface == CellSurface::bilinear) return (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d);
    return u + v <= 1 ? a + u * (b - a) + v * (c - a) : d + (1 - u) * (c - d) + (1 - v) * (b - d);
}

/// How far a line keeps above the ground, at many points between its ends.
double least_clearance(const Ground& ground, CellSurface surface, const glm::dvec3& from, const glm::dvec3& to) {
    constexpr int kPoints = 4000;
    double least = HUGE_VAL;
    for (int n = 1; n < kPoints; ++n) {
        const glm::dvec3 point = from + (to - from) * (static_cast<double>(n) / kPoints);
        least = std::min(least, point.z - height_of(ground, surface, point.x, point.y));
    }
    return least;
}

TEST(Sight, IsFreeWhereALineKeepsAboveTheGround) {
    const Ground ground(test_support::fractal_heights(129));
    test_support::Dice dice(5);
    for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear}) {
        int free = 0, hidden = 0, close = 0;
        for (int n = 0; n < 3000; ++n) {
            const auto place = [&] {
                const double x = dice.between(0, 128), y = dice.between(0, 128);
                return glm::dvec3(x, y, height_of(ground, surface, x, y) + dice.between(0, 3000));
            };
            const glm::dvec3 from = place(), to = place();
            const double clearance = least_clearance(ground, surface, from, to);
            if (std::abs(clearance) < 3) {  // between points of the brute force
                ++close;
                continue;
            }
            (clearance > 0 ? free : hidden) += 1;
            ASSERT_EQ(is_visible(ground.traced(surface), from, to), clearance > 0) << n << " " << clearance;
        }
        EXPECT_GT(free, 300);
        EXPECT_GT(hidden, 300);
        EXPECT_LT(close, 600);
    }
}

TEST(Sight, TheGroundThatItsEndsStandOnHidesNothing) {
    // A plane as steep as it can be: every place of it sees every other, both on the ground.
    test_support::HeightField<std::int16_t> posts(65, 65);
    for (std::uint32_t row = 0; row < 65; ++row)
        for (std::uint32_t column = 0; column < 65; ++column)
            posts.at(column, row) = static_cast<std::int16_t>(300 * column + 200 * row - 16000);
    const Ground ground(posts);
    const Ground hills(test_support::rough_heights(65, 65, 30000, 3));
    test_support::Dice dice(2);
    int hidden_without_lift = 0;
    for (int n = 0; n < 3000; ++n) {
        const auto place = [&](const Ground& on, double above) {
            const double x = dice.between(0, 64), y = dice.between(0, 64);
            return glm::dvec3(x, y, height_of(on, CellSurface::two_triangles, x, y) + above);
        };
        const glm::dvec3 from = place(ground, 0), to = place(ground, 0);
        ASSERT_TRUE(is_visible(ground.traced(CellSurface::two_triangles), from, to)) << n;
        hidden_without_lift += is_occluded(ground.traced(CellSurface::two_triangles), from, to) ? 1 : 0;
        const glm::dvec3 foot = place(hills, 0);
        EXPECT_TRUE(is_visible(hills.traced(CellSurface::two_triangles), foot, foot + glm::dvec3(0, 0, 50000)));
    }
    EXPECT_GT(hidden_without_lift, 100);
}

TEST(Sight, ManyTargetsAreOneByOne) {
    const Ground ground(test_support::fractal_heights(65));
    const glm::dvec3 eye(20.2, 30.7, 9000);
    std::vector<glm::dvec3> targets;
    for (int n = 0; n < 60; ++n) targets.emplace_back(n, 64 - n, 3000 + 40 * n);
    std::vector<std::uint8_t> seen(targets.size(), 9);
    const TracedField<std::int16_t> field = ground.traced(CellSurface::two_triangles);
    find_visible<std::int16_t>(field, eye, targets, seen);
    for (std::size_t n = 0; n < targets.size(); ++n) EXPECT_EQ(seen[n], is_visible(field, eye, targets[n]) ? 1 : 0);
}

TEST(Viewshed, IsThatOfABruteForceForAnyWorkers) {
    test_support::HeightField<std::int16_t> posts = test_support::fractal_heights(97);
    posts.at(50, 40) = HeightGrid<std::int16_t>::kVoid;
    const Ground ground(posts), whole(test_support::fractal_heights(97));
    Viewshed viewshed;
    viewshed.observer = {48.5, 48.5, height_of(whole, CellSurface::two_triangles, 48.5, 48.5) + 1500};
    viewshed.target_height = 20;
    viewshed.window = {10, 20, 90, 80};
    std::vector<std::uint8_t> alone(80 * 60, 9), shared(alone.size(), 8);
    base::SerialWorkers one;
    const TracedField<std::int16_t> field = ground.traced(CellSurface::two_triangles);
    find_viewshed<std::int16_t>(field, viewshed, one, alone);
    const auto three = platform::make_thread_workers({3, nullptr});
    find_viewshed<std::int16_t>(field, viewshed, *three.value(), shared);
    EXPECT_EQ(alone, shared);
    int seen = 0, hidden = 0;
    for (std::uint32_t row = 20; row < 80; ++row)
        for (std::uint32_t column = 10; column < 90; ++column) {
            const std::uint8_t found = alone[(row - 20) * 80 + column - 10];
            if (std::abs(static_cast<int>(column) - 50) < 12 && row < 48) continue;  // lines that pass the hole
            const glm::dvec3 target(column, row, whole.field.at(column, row) + 20.0);
            const double clearance = least_clearance(whole, CellSurface::two_triangles, viewshed.observer, target);
            if (std::abs(clearance) < 3) continue;
            (found == 1 ? seen : hidden) += 1;
            ASSERT_EQ(found == 1, clearance > 0) << column << " " << row << " " << clearance;
        }
    EXPECT_GT(seen, 300);
    EXPECT_GT(hidden, 300);
    EXPECT_EQ(alone[(40 - 20) * 80 + 50 - 10], 0);
}

}  // namespace
}  // namespace tedavis::raytrace
