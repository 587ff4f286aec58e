#include "render_core/earth/magnified_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "render_core/base/units.hpp"

namespace tedavis::earth::test_magnified_parts {
namespace {

using base::radians;

Magnifier magnifier_at(double latitude_deg, bool is_square) {
    Magnifier magnifier;
    EXPECT_TRUE(Magnifier::make({radians(latitude_deg), radians(9.8), is_square, 2000, 9000, 1}, magnifier));
    return magnifier;
}

/// Two near each other, as near as they may be.
Magnifiers two() {
    Magnifiers all;
    EXPECT_TRUE(all.add(magnifier_at(46.8, false)));
    EXPECT_TRUE(all.add(magnifier_at(46.94, true)));
    return all;
}

GroundExtent box_at(const Magnifier& by, const glm::dvec2& at, double half_m) {
    GroundExtent extent;
    extent.centre = by.middle() + by.east() * at.x + by.north() * at.y + by.up() * 1500.0;
    extent.half[0] = by.north() * half_m;
    extent.half[1] = by.east() * half_m;
    extent.half[2] = by.up() * 1000.0;
    return extent;
}

bool is_inside(const MagnifiedPart& part, const glm::dvec2& ground) {
    if (part.cell.inside_m(ground) < 0) return false;
    for (const glm::dvec3& limit : part.limits)
        if (glm::dot(limit, glm::dvec3(ground, 1)) < 0) return false;
    return true;
}

/// Every place of an extent is in one part, which moves it as the magnifiers do, and in no other but on borders.
TEST(MagnifiedParts, CoverAnExtentOnceAndMoveItAsTheMagnifiersDo) {
    const Magnifiers all = two();
    const Magnifier& first = *all.begin();
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> aside(-12'000, 12'000), along(-12'000, 30'000), share(-1, 1), half(200, 9000);
    int doubled = 0, places = 0, most = 0;
    for (int k = 0; k < 300; ++k) {
        const GroundExtent extent = box_at(first, {aside(random), along(random)}, half(random));
        if (!is_magnified(all, extent)) continue;
        most = std::max(most, static_cast<int>(count_parts(all, extent)));
        for (int n = 0; n < 50; ++n) {
            Ecef place = extent.centre;
            for (const glm::dvec3& axis : extent.half) place += axis * share(random);
            int found = 0;
            MagnifiedParts parts(all, extent);
            for (MagnifiedPart part; parts.next(part);) {
                const glm::dvec2 ground = part.magnifier->in_plane(place);
                if (!is_inside(part, ground)) continue;
                ++found;
                const Ecef moved = part.magnifier->shifted(place, ground, part.cell.slope * ground + part.cell.shift);
                ASSERT_LT(glm::distance(moved, all.moved(place)), 1e-6);
            }
            ++places;
            doubled += found > 1 ? 1 : 0;
            ASSERT_GE(found, 1) << k << ' ' << n;
        }
    }
    EXPECT_GT(places, 5000);
    EXPECT_LT(doubled, places / 100);  // limits reach over each other
    EXPECT_GT(most, 20);
}

TEST(MagnifiedParts, WhatIsFarAwayIsOnePieceAndNotMagnified) {
    const Magnifiers all = two();
    const GroundExtent extent = box_at(*all.begin(), {40'000, 0}, 1000);
    EXPECT_FALSE(is_magnified(all, extent));
    EXPECT_EQ(count_parts(all, extent), 1u);
    EXPECT_EQ(count_parts({}, box_at(*all.begin(), {0, 0}, 1000)), 1u);
}

TEST(MagnifiedParts, TheFocusAloneIsOneDraw) {
    const Magnifiers all = two();
    const GroundExtent extent = box_at(*all.begin(), {100, 100}, 500);
    EXPECT_EQ(count_parts(all, extent), 1u);
    MagnifiedParts parts(all, extent);
    MagnifiedPart part;
    ASSERT_TRUE(parts.next(part));
    EXPECT_NEAR(part.scale(), 2, 1e-12);
    EXPECT_FALSE(parts.next(part));
}

TEST(GroundExtent, ReachesAsFarAsItsCorners) {
    GroundExtent extent;
    extent.half[0] = {3, 0, 0};
    extent.half[1] = {0, 4, 0};
    extent.more_m = 1;
    EXPECT_DOUBLE_EQ(extent.radius_m(), 6);
    EXPECT_DOUBLE_EQ(extent.along({0.6, 0.8, 0}), 1 + 1.8 + 3.2);
}

}  // namespace
}  // namespace tedavis::earth::test_magnified_parts
