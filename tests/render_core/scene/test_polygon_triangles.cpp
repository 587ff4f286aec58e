#include "render_core/scene/polygon_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tedavis::scene::test_polygon_triangles {
namespace {

using Corners = std::vector<glm::dvec2>;

std::vector<std::uint16_t> cut(const Corners& corners) {
    std::vector<std::uint16_t> triangles(corners.size() < 3 ? 0 : 3 * (corners.size() - 2));
    triangles.resize(triangulate({corners.data(), corners.size()}, {triangles.data(), triangles.size()}));
    return triangles;
}

double area(const Corners& corners) { return 0.5 * twice_area({corners.data(), corners.size()}); }

double area_of_triangles(const Corners& corners, const std::vector<std::uint16_t>& triangles) {
    double sum = 0;
    for (std::size_t n = 0; n + 2 < triangles.size(); n += 3) {
        const double one = area({corners[triangles[n]], corners[triangles[n + 1]], corners[triangles[n + 2]]});
        EXPECT_GT(one, 0) << "counter-clockwise";
        sum += one;
    }
    return sum;
}

/// A point is inside by the crossings of a ray with the border.
bool inside(const Corners& corners, const glm::dvec2& p) {
    bool in = false;
    for (std::size_t n = 0, before = corners.size() - 1; n < corners.size(); before = n++) {
        const glm::dvec2 &a = corners[n], &b = corners[before];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
    }
    return in;
}

/// A star about the origin: simple, seldom convex.
Corners star(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(0.2, 1.0);
    Corners corners;
    for (std::size_t n = 0; n < count; ++n) {
        const double angle = 6.283185307179586 * static_cast<double>(n) / static_cast<double>(count), r = radius(random);
        corners.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return corners;
}

TEST(PolygonTriangles, CoverTheAreaOnceWhicheverWayItRuns) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Corners corners = star(seed, 5 + seed * 3);
        const double expected = area(corners);
        EXPECT_NEAR(area_of_triangles(corners, cut(corners)), expected, 1e-12);
        Corners turned(corners.rbegin(), corners.rend());
        EXPECT_NEAR(area_of_triangles(turned, cut(turned)), expected, 1e-12);
    }
}

TEST(PolygonTriangles, LieInsideTheBorder) {
    const Corners corners = star(7, 40);
    const auto triangles = cut(corners);
    ASSERT_EQ(triangles.size(), 3u * 38u);
    for (std::size_t n = 0; n + 2 < triangles.size(); n += 3)
        EXPECT_TRUE(inside(corners, (corners[triangles[n]] + corners[triangles[n + 1]] + corners[triangles[n + 2]]) / 3.0));
}

TEST(PolygonTriangles, CornersOnALineAndTwiceTheSameAreBorne) {
    const Corners corners{{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}};
    EXPECT_NEAR(area_of_triangles(corners, cut(corners)), 4, 1e-12);
}

TEST(PolygonTriangles, WhatCrossesItselfEnds) {
    const Corners bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    EXPECT_LE(cut(bow).size(), 6u);
    EXPECT_TRUE(cut({{0, 0}, {1, 1}, {2, 2}}).empty()) << "no area";
}

TEST(PolygonTriangles, TooFewTooManyAndTooLittleRoomGiveNone) {
    EXPECT_TRUE(cut({{0, 0}, {1, 1}}).empty());
    EXPECT_TRUE(cut(star(1, kMaxPolygonCorners + 1)).empty());
    EXPECT_EQ(cut(star(1, kMaxPolygonCorners)).size(), 3 * (kMaxPolygonCorners - 2));
    const Corners square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::uint16_t room[5];
    EXPECT_EQ(triangulate({square.data(), square.size()}, {room, 5}), 0u);
}

}  // namespace
}  // namespace tedavis::scene::test_polygon_triangles
