#include "render_core/scene/focus_region.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <random>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::scene::test_focus_region {
namespace {

using base::radians;

FocusRegion disc(double radius_m, const FocusContext& context = {}) {
    FocusRegion region = focus_region_at(radians(46.8), radians(9.8));
    region.radius_m = radius_m;
    region.context = context;
    region.points[0] = {0, 0};
    region.point_count = 1;
    return region;
}

FocusRegion way(std::initializer_list<glm::dvec2> points, double radius_m, FocusDistance distance) {
    FocusRegion region = disc(radius_m, {distance, 3000, 0});
    region.kind = FocusPoints::path;
    std::copy(points.begin(), points.end(), region.points.begin());
    region.point_count = static_cast<std::uint32_t>(points.size());
    return region;
}

double by(FocusDistance distance, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 way = glm::abs(a - b);
    return distance == FocusDistance::euclidean ? std::hypot(way.x, way.y) : std::max(way.x, way.y);
}

/// By places of the focus themselves, none of which the code looks at.
double brute_force(const FocusRegion& region, const glm::dvec2& ground) {
    double least = 1e18;
    const auto look = [&](const glm::dvec2& place) { least = std::min(least, by(region.context.distance, ground, place)); };
    if (region.kind == FocusPoints::path) {
        for (std::uint32_t n = 0; n + 1 < region.point_count; ++n)
            for (int k = 0; k <= 4000; ++k) look(glm::mix(region.points[n], region.points[n + 1], k / 4000.0));
        return std::max(least - region.radius_m, 0.0);
    }
    for (std::uint32_t n = 0; n < region.point_count; ++n)
        for (int k = 0; k < 4000; ++k) {
            const double turn = k * 2 * std::acos(-1.0) / 4000, r = region.radius_m;
            const glm::dvec2 round{std::cos(turn), std::sin(turn)};
            const glm::dvec2 rim = region.is_square ? round / std::max(std::fabs(round.x), std::fabs(round.y)) : round;
            look(region.points[n] + rim * r);
            const glm::dvec2 from = ground - region.points[n];
            const bool is_in =
                region.is_square ? std::max(std::fabs(from.x), std::fabs(from.y)) <= r : glm::dot(from, from) <= r * r;
            if (is_in) return 0;
        }
    return least;
}

TEST(FocusRegion, DistancesAreThoseOfPlacesTriedOneByOne) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(-6000, 6000);
    for (const bool is_square : {false, true})
        for (const FocusDistance distance : {FocusDistance::euclidean, FocusDistance::chebyshev}) {
            FocusRegion places = disc(900, {distance, 3000, 0});
            places.is_square = is_square;
            places.points[1] = {2500, -1200};
            places.point_count = 2;
            const FocusRegion path = way({{-3000, -500}, {0, 800}, {0, 800}, {2500, 800}}, 400, distance);
            for (int n = 0; n < 300; ++n) {
                const glm::dvec2 ground{place(random), place(random)};
                EXPECT_NEAR(focus_distance_m(places, ground), brute_force(places, ground), 2) << ground.x << " " << ground.y;
                EXPECT_NEAR(focus_distance_m(path, ground), brute_force(path, ground), 2) << ground.x << " " << ground.y;
            }
        }
    EXPECT_GT(std::fabs(focus_distance_m(disc(900), {2000, 2000}) - brute_force(disc(800), {2000, 2000})), 50) << "a control";
}

TEST(FocusRegion, ThePlaneIsTheGroundWithinWhatItSays) {
    const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
    const FocusRegion region = disc(1);
    for (const double length_m : {1000.0, 30'000.0, 100'000.0})
        for (double turn = 0; turn < 360; turn += 30) {
            double lat = 0, lon = 0;
            earth.Direct(46.8, 9.8, turn, length_m, lat, lon);
            const glm::dvec2 ground = in_focus_plane(region, earth::to_ecef({radians(lat), radians(lon), {0}}));
            EXPECT_NEAR(glm::length(ground), length_m, 1.3e-4 * length_m * (length_m / 100'000) * (length_m / 100'000) + 0.01);
            EXPECT_NEAR(std::remainder(std::atan2(ground.x, ground.y) - radians(turn), 2 * std::acos(-1.0)), 0, 1e-4);
            const glm::dvec2 above = in_focus_plane(region, earth::to_ecef({radians(lat), radians(lon), {3000}}));
            EXPECT_NEAR(glm::length(above) - glm::length(ground), 3000 * length_m / 6.371e6, 0.5);
        }
}

TEST(FocusRegion, TheDegreeFallsInStepsOrEvenly) {
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 0, 1}, 0.1), 0);
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 1000, 1}, 999), 0.5);
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 1000, 1}, 1000), 0);
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 1000, 3}, 1), 0.75);
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 1000, 3}, 400), 0.5);
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 1000, 3}, 999), 0.25);
    EXPECT_EQ(degree_at_distance({FocusDistance::euclidean, 1000, 0}, 250), 0.75);
    for (const std::uint32_t levels : {0u, 1u, 2u, 16u}) {
        double last = 1;
        for (double distance_m = 1; distance_m < 1000; distance_m += 1) {
            const double degree = degree_at_distance({FocusDistance::euclidean, 1000, levels}, distance_m);
            EXPECT_LE(degree, last);
            EXPECT_GT(degree, 0);
            EXPECT_LT(degree, 1);
            last = degree;
        }
    }
}

TEST(FocusRegion, WhatIsOverOrUnderAVolumeIsBesideIt) {
    FocusRegion ball = disc(1000, {FocusDistance::euclidean, 2000, 0});
    ball.is_volume = ball.is_ball = true;
    ball.lower_m = ball.upper_m = 3000;
    const glm::dvec3 middle = ball.anchor + ball.up * 3000.0;
    EXPECT_EQ(focus_degree(ball, middle, 3000), 1);
    EXPECT_EQ(focus_degree(ball, middle + ball.up * 900.0, 3900), 1);
    EXPECT_EQ(focus_degree(ball, middle + ball.up * 1100.0, 4100), kMaxBesideVolume);
    EXPECT_EQ(focus_degree(ball, middle + ball.up * 900.0 + ball.east * 900.0, 3900), kMaxBesideVolume);
    EXPECT_EQ(focus_degree(ball, ball.anchor, 0), kMaxBesideVolume);
    EXPECT_EQ(ground_focus_degree(ball, {0, 0}), 1) << "the ground below it";
    FocusRegion box = ball;
    box.is_ball = false;
    box.is_square = true;
    box.lower_m = 1000;
    box.upper_m = 2000;
    EXPECT_EQ(focus_degree(box, box.anchor + box.east * 999.0, 1500), 1);
    EXPECT_EQ(focus_degree(box, box.anchor, 999), kMaxBesideVolume);
    EXPECT_EQ(focus_degree(box, box.anchor, 2001), kMaxBesideVolume);
    EXPECT_NEAR(focus_degree(box, box.anchor + box.east * 2800.0, 1500), 0.1, 1e-9) << "farther away heights no longer matter";
}

TEST(FocusRegion, OfSeveralTheGreatestCounts) {
    FocusRegions regions;
    const glm::dvec3 place = disc(1).anchor;
    EXPECT_EQ(focus_degree(regions, place, 0), 1) << "without a focus nothing steps back";
    FocusRegion far = disc(1000);
    far.points[0] = {80'000, 0};
    ASSERT_TRUE(regions.try_push_back(far));
    EXPECT_EQ(focus_degree(regions, place, 0), 0);
    FocusRegion near = disc(1000);
    near.points[0] = {3000, 0};
    ASSERT_TRUE(regions.try_push_back(near));
    EXPECT_EQ(focus_degree(regions, place, 0), 0.5);
    EXPECT_EQ(ground_focus_degree(regions, place), 0.5);
    near.is_valid = false;
    near.points[0] = {0, 0};
    ASSERT_TRUE(regions.try_push_back(near));
    EXPECT_EQ(focus_degree(regions, place, 0), 0.5) << "a focus that is nowhere";
    FocusRegions nowhere;
    ASSERT_TRUE(nowhere.try_push_back(near));
    EXPECT_EQ(ground_focus_degree(nowhere, place), 1);
}

}  // namespace
}  // namespace tedavis::scene::test_focus_region
