#include "host_sim/reports/map_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tedavis::host_sim::test_map_lines {
namespace {

constexpr double kWide = 100, kHigh = 60;

TEST(MapLines, ALineInsideStaysAsItIs) {
    const MapLine line{{0, 0}, {50, 30}, {100, 60}, {100, 0}};
    const auto within = lines_within({line}, kWide, kHigh);
    ASSERT_EQ(within.size(), 1u);
    ASSERT_EQ(within[0].size(), 4u);
    for (std::size_t n = 0; n < 4; ++n) {
        EXPECT_EQ(within[0][n].x, line[n].x);
        EXPECT_EQ(within[0][n].y, line[n].y);
    }
}

TEST(MapLines, WhatLeavesAndComesBackIsTwo) {
    const auto within = lines_within({{{50, 30}, {150, 30}, {150, 50}, {50, 50}}}, kWide, kHigh);
    ASSERT_EQ(within.size(), 2u);
    EXPECT_EQ(within[0].back().x, 100);
    EXPECT_EQ(within[0].back().y, 30);
    EXPECT_EQ(within[1].front().x, 100);
    EXPECT_EQ(within[1].front().y, 50);
    EXPECT_EQ(within[1].back().x, 50);
}

TEST(MapLines, ALegMayCrossTheWholeDrawing) {
    const auto within = lines_within({{{-50, -50}, {150, 150}}}, kWide, kHigh);
    ASSERT_EQ(within.size(), 1u);
    EXPECT_NEAR(within[0][0].x, 0, 1e-12);
    EXPECT_NEAR(within[0][1].y, 60, 1e-12);
    EXPECT_TRUE(lines_within({{{-50, 10}, {10, -50}}}, kWide, kHigh).empty()) << "past a corner";
    EXPECT_TRUE(lines_within({{{200, 10}, {200, 50}}}, kWide, kHigh).empty());
    EXPECT_TRUE(lines_within({{{50, 30}}, {}}, kWide, kHigh).empty()) << "no leg";
}

double length_of(const std::vector<MapLine>& lines) {
    double sum = 0;
    for (const MapLine& line : lines)
        for (std::size_t n = 1; n < line.size(); ++n) sum += std::hypot(line[n].x - line[n - 1].x, line[n].y - line[n - 1].y);
    return sum;
}

/// Against legs that are cut into small steps, of which those inside are added up.
TEST(MapLines, TheLengthInsideIsThatOfItsSmallSteps) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-80, 180), y(-60, 120);
    MapLine line;
    for (int n = 0; n < 200; ++n) line.push_back({x(random), y(random)});
    const auto within = lines_within({line}, kWide, kHigh);
    for (const MapLine& part : within)
        for (const MapPoint& point : part)
            EXPECT_TRUE(is_within({std::round(point.x * 1e9) / 1e9, std::round(point.y * 1e9) / 1e9}, kWide, kHigh));
    double stepped = 0;
    constexpr int kSteps = 4000;
    for (std::size_t n = 1; n < line.size(); ++n) {
        const MapPoint &a = line[n - 1], &b = line[n];
        for (int step = 0; step < kSteps; ++step) {
            const double share = (step + 0.5) / kSteps;
            if (is_within({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}, kWide, kHigh))
                stepped += std::hypot(b.x - a.x, b.y - a.y) / kSteps;
        }
    }
    EXPECT_NEAR(length_of(within), stepped, 1e-3 * stepped);
}

}  // namespace
}  // namespace tedavis::host_sim::test_map_lines
