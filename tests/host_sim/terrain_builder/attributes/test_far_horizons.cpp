#include "host_sim/terrain_builder/attributes/far_horizons.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/terrain/attribute_terrain.hpp"

namespace tedavis::host_sim::test_far_horizons {
namespace {

using terrain::kHorizonDirections;
using terrain::PostClass;
using test_support::HeightSquare;
using test_support::make_tile;
using test_support::post_of;
using test_support::view_of;

constexpr int kEast = 4;

double tangent(const FarHorizons& far, int column, int row, std::size_t direction, double height_m) {
    const FarLines& lines = far.lines[far.at(column, row)];
    return static_cast<double>(lines.intercept[direction]) - static_cast<double>(lines.per_m[direction]) * height_m;
}

/// A ridge 480 m high runs north, 12 posts east of column 0.
AttributeTile ridge_tile() {
    return make_tile(6, 4, 40, 40, [](int i, int) { return i == 12 ? 580.0 : 100.0; });
}

TEST(FarHorizons, ALevelSeesFromEightToSixteenPosts) {
    const AttributeTile tile = ridge_tile();
    const FarHorizons far = make_far_horizons(HeightPlanes(tile), {});
    EXPECT_NEAR(tangent(far, 0, 0, kEast, 100), 480.0 / 480 - 480 / (2 * 6371000.0), 1e-6);
    EXPECT_NEAR(tangent(far, 0, 0, kEast, 340), 240.0 / 480 - 480 / (2 * 6371000.0), 1e-6) << "of an eye halfway up";
    EXPECT_NEAR(tangent(far, -4, 3, kEast, 100), 480.0 / 640, 1e-3) << "16 posts away, in the margin";
    EXPECT_NEAR(tangent(far, 5, 0, kEast, 100), 0, 1e-3) << "7 posts away: the level below sees it itself";
    EXPECT_NEAR(tangent(far, -5, 0, kEast, 100), 0, 1e-3) << "17 posts away: the level above sees it";
    EXPECT_NEAR(tangent(far, 0, 0, kEast + 1, 100), 480 / std::hypot(480, 240), 1e-3) << "a knight's direction meets it too";
}

TEST(FarHorizons, WhatTheLevelAboveSeesIsHandedOnWhereItIsHigher) {
    FarHorizons above;
    above.columns = 3;
    above.rows = 2;
    above.lines.resize(static_cast<std::size_t>(3 + 2 * kFarMargin) * (2 + 2 * kFarMargin));
    above.known.assign(above.lines.size(), 1);
    for (FarLines& lines : above.lines) {
        lines.intercept.fill(2.5f);  // at 100 m: 1.5
        lines.per_m.fill(0.01f);
    }
    const AttributeTile tile = ridge_tile();
    const FarHorizons far = make_far_horizons(HeightPlanes(tile), view_of(above));
    EXPECT_NEAR(tangent(far, 0, 0, kEast, 100), 1.5, 1e-6);
    EXPECT_NEAR(tangent(far, 0, 0, kEast, 0), 2.5, 1e-6);
    for (FarLines& lines : above.lines) lines.intercept.fill(1.5f);  // at 100 m: 0.5
    const FarHorizons lower = make_far_horizons(HeightPlanes(tile), view_of(above));
    EXPECT_NEAR(tangent(lower, 0, 0, kEast, 100), 1, 1e-3) << "the ridge is higher";
    EXPECT_NEAR(tangent(lower, 0, 0, 0, 100), 0.5, 1e-6) << "north has no ridge";
}

// All patterns of voids round a place: the horizons of the valid corners count, their weights made whole again.
TEST(FarHorizons, RowsAreInterpolatedBetweenValidPosts) {
    FarHorizons above;
    above.columns = above.rows = 2;
    above.lines.resize(static_cast<std::size_t>(2 + 2 * kFarMargin) * (2 + 2 * kFarMargin));
    const double weights[4] = {0.75 * 0.75, 0.25 * 0.75, 0.75 * 0.25, 0.25 * 0.25};
    for (int pattern = 0; pattern < 16; ++pattern) {
        above.known.assign(above.lines.size(), 1);
        double sum = 0, weight = 0;
        for (int corner = 0; corner < 4; ++corner) {
            const std::size_t at = above.at(corner % 2, corner / 2);
            above.lines[at].intercept.fill(static_cast<float>(corner + 1));
            above.lines[at].per_m.fill(0.5f);
            if ((pattern >> corner & 1) != 0) {
                above.known[at] = 0;
                above.lines[at].intercept.fill(9e6f);
                continue;
            }
            sum += weights[corner] * (corner + 1);
            weight += weights[corner];
        }
        FarRow row({&above, 0.25, 0.25}, 0, 1);
        row.read(0);
        const Lanes seen = row.tangent(3, 0, all(2));
        if (pattern == 15)
            EXPECT_LT(seen[0], 0.5f * kNoHorizon) << "nothing is known";
        else
            EXPECT_NEAR(seen[0], sum / weight - 1, 1e-5) << pattern;
    }
}

TEST(FarHorizons, WithoutALevelAboveNothingIsSeen) {
    FarRow row({}, -kFarMargin, 5);
    row.read(3);
    EXPECT_EQ(row.tangent(0, 0, all(500))[0], kNoHorizon);
    AttributeTile tile = ridge_tile();
    tile.post_class.assign(tile.post_class.size(), PostClass::outside);
    tile.post_class[post_of(tile, 2, 2)] = PostClass::land;
    const FarHorizons far = make_far_horizons(HeightPlanes(tile), {});
    EXPECT_EQ(far.known[far.at(2, 2)], 1);
    EXPECT_EQ(far.known[far.at(2, 1)], 0);
    for (std::size_t k = 0; k < kHorizonDirections; ++k) EXPECT_EQ(tangent(far, 2, 2, k, 100), kNoHorizon);
}

// Oracle: every post of the full resolution along the four straight directions.
TEST(FarHorizons, APyramidSeesAWallAtAnyDistance) {
    HeightSquare ground{256, std::vector<double>(256 * 256, 50.0), 30};
    for (int j = 0; j < 256; ++j)
        for (int i = 200; i < 232; ++i) ground.height_m[index_of(i, j, 256)] = 2050;
    const FarHorizons far = ground.halved().far_horizons();
    for (const int column : {3, 20, 40, 66, 80, 91}) {  // of the level above; a post there lies at 2 column + 0.5
        const double distance_m = 30 * (200 - (2 * column + 0.5)), truth = 2000 / distance_m - distance_m / 2 / 6371000;
        const double seen = tangent(far, column, 64, kEast, 50);
        EXPECT_LT(seen, 1.01 * truth) << distance_m;
        EXPECT_GT(seen, truth * 8 / 9) << distance_m << " the edge of a wall lies up to one post of at least 8 nearer";
    }
    EXPECT_LT(tangent(far, 60, 64, 12, 50), 1e-6) << "nothing in the west";
}

}  // namespace
}  // namespace tedavis::host_sim::test_far_horizons
