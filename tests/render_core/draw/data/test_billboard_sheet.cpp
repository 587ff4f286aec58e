#include "render_core/draw/data/billboard_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "render_core/draw/drawers/view_projection.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_billboard_sheet {
namespace {

using test_support::BillboardRoom;

TEST(BillboardSheet, SpotsLieWhereThePerspectivePutsThem) {
    const BillboardRoom room;
    const terrain::View& view = room.view;
    for (const glm::dvec3& offset : {glm::dvec3(500, 120, -40), glm::dvec3(30'000, -9000, 2000), glm::dvec3(2, 0.5, 0.5)}) {
        const glm::dvec3 from_eye = view.forward * offset.x + view.right * offset.y + view.down * offset.z;
        const BillboardSheet::Spot spot = room.sheet.spot(view.eye + from_eye);
        const glm::dvec4 clip = view_projection(view, {1, 50'000}) * glm::dvec4(from_eye, 1);
        ASSERT_TRUE(spot.is_ahead);
        EXPECT_NEAR(spot.at.x, (clip.x / clip.w + 1) * 400, 1e-3);
        EXPECT_NEAR(spot.at.y, (1 - clip.y / clip.w) * 300, 1e-3);
        EXPECT_NEAR(spot.distance_m, clip.w, 1e-6);
    }
}

TEST(BillboardSheet, NothingStandsBehindTheEye) {
    const BillboardRoom room;
    EXPECT_FALSE(room.sheet.spot(room.view.eye - room.view.forward * 100.0).is_ahead);
    EXPECT_FALSE(room.sheet.spot(room.view.eye + room.view.forward * 0.5).is_ahead) << "nor before the near plane";
    EXPECT_FALSE(room.sheet.spot(glm::dvec3(std::numeric_limits<double>::quiet_NaN())).is_ahead);
    room.sheet.line(room.sheet.spot(room.view.eye - room.view.forward), room.sheet.spot(room.view.eye + room.view.forward * 9.0),
                    1, {});
    EXPECT_TRUE(room.drawn().empty());
}

TEST(BillboardSheet, WhoComesFirstHasTheRoom) {
    BillboardRoom room;
    const glm::dvec3 place = room.view.eye + room.view.forward * 1000.0;
    EXPECT_TRUE(room.sheet.claim({100, 100, 50, 20}, place));
    EXPECT_FALSE(room.sheet.claim({149, 110, 50, 20}, place));
    EXPECT_TRUE(room.sheet.claim({150, 100, 50, 20}, place)) << "boxes that only touch do not cover each other";
    EXPECT_FALSE(room.sheet.claim({-1, 300, 50, 20}, place)) << "beyond the picture";
    EXPECT_FALSE(room.sheet.claim({780, 300, 50, 20}, place));
    room.begin();
    EXPECT_TRUE(room.sheet.is_free({149, 110, 50, 20}));
    EXPECT_TRUE(room.sheet.claim({149, 110, 50, 20}, place)) << "a new frame";
}

TEST(BillboardSheet, TheBestCandidatesAreKeptInOrder) {
    BillboardRoom room;
    std::vector<double> ranks;
    std::uint32_t state = 1;
    room.sheet.begin_candidates();
    for (std::uint32_t n = 0; n < 5000; ++n) {
        state = state * 1664525u + 1013904223u;
        ranks.push_back(state >> 20);
        room.sheet.offer({ranks.back(), n});
    }
    room.sheet.offer({std::numeric_limits<double>::quiet_NaN(), 9});
    std::vector<std::uint32_t> expected(ranks.size());
    for (std::uint32_t n = 0; n < 5000; ++n) expected[n] = n;
    std::stable_sort(expected.begin(), expected.end(), [&](auto a, auto b) { return ranks[a] < ranks[b]; });
    const auto ranked = room.sheet.ranked();
    ASSERT_EQ(ranked.size(), BillboardSheet::kMaxCandidates);
    for (std::size_t n = 0; n < ranked.size(); ++n) EXPECT_EQ(ranked[n].feature, expected[n]);
}

/// The eye of a map stands ten thousand kilometres up, its near plane 9 km over the sea.
TEST(BillboardSheet, LinesHaveTheDepthsOfTheirEnds) {
    BillboardRoom room;
    const BillboardSheet::Spot near = room.sheet.spot(room.view.eye + room.view.forward * 200.0 + room.view.down * 20.0);
    const BillboardSheet::Spot far = room.sheet.spot(room.view.eye + room.view.forward * 900.0);
    room.sheet.line(near, far, 2, {});
    ASSERT_EQ(room.drawn().size(), 8u) << "with its rim";
    for (const QuadVertex& vertex : room.drawn()) {
        const bool is_near = std::abs(vertex.y - near.at.y) < std::abs(vertex.y - far.at.y);
        EXPECT_NEAR(vertex.distance_m, (is_near ? 200 : 900) * (1 - terrain::LineOfSight::kTail), 0.01);
    }
}

TEST(BillboardSheet, SeenFromFarAwaySignsStandHardlyBeforeTheirPlaces) {
    test_support::BillboardRoom room;
    const double usual_m = room.sheet.seen_distance_m(20'000);
    EXPECT_NEAR(usual_m, 20'000, 1e-6);
    // A thousand times as far, and as narrow: what is seen is as wide.
    const glm::dvec3 place = room.view.eye + room.view.forward * 20'000.0;
    room.view.eye = place - room.view.forward * 20e6;
    room.view.focal_px *= 1000;
    room.begin();
    EXPECT_NEAR(room.sheet.seen_distance_m(20e6), usual_m, 1);
    room.sheet.stem(room.sheet.spot(place), {10, 10}, 2, {1, 2, 3});
    const double before_m = 20e6 - static_cast<double>(room.links.vertices()[0].distance_m);
    EXPECT_GT(before_m, 50);
    EXPECT_LT(before_m, 200) << "not the hundred kilometres that are the same share of its distance";
}

TEST(BillboardSheet, ALinkHasAMarkOnTheGround) {
    test_support::BillboardRoom room;
    const auto top = room.sheet.spot(room.view.eye + room.view.forward * 5000.0);
    const auto ground = room.sheet.spot(room.view.eye + room.view.forward * 5000.0 + room.view.down * 700.0);
    room.sheet.link(ground, top, {200, 100, 50});
    const Rect bounds = room.bounds();
    EXPECT_NEAR(static_cast<double>(bounds.y), 300, 3);
    EXPECT_NEAR(static_cast<double>(bounds.bottom()), static_cast<double>(ground.at.y), 3);
    EXPECT_GT(bounds.width, 6) << "its mark";
    EXPECT_EQ(room.drawn().size(), BillboardSheet::kLinkVertices);
}

TEST(BillboardSheet, WhatTheSymbologyCoversIsNotFree) {
    BillboardRoom room, symbology;
    ASSERT_TRUE(symbology.batch.box({200, 200, 100, 50}, {}));
    ASSERT_TRUE(symbology.batch.line({400, 500}, {600, 300}, 3, {}));
    const glm::dvec3 place = room.view.eye + room.view.forward * 1000.0;
    room.sheet.begin({room.batch, room.links, room.view, 16, nullptr, &symbology.batch});
    EXPECT_FALSE(room.sheet.claim({290, 240, 50, 20}, place));
    EXPECT_FALSE(room.sheet.claim({480, 390, 40, 20}, place)) << "a line runs through";
    EXPECT_TRUE(room.sheet.claim_under_symbology({480, 390, 40, 20}, place)) << "which hides nobody else's aircraft";
    EXPECT_FALSE(room.sheet.claim_under_symbology({490, 390, 40, 20}, place)) << "but signs keep clear of each other";
    EXPECT_TRUE(room.sheet.claim({420, 320, 40, 20}, place)) << "within its bounds, but clear of it";
    EXPECT_TRUE(room.sheet.claim({320, 260, 50, 20}, place));
    room.begin();
    EXPECT_TRUE(room.sheet.claim({290, 240, 50, 20}, place)) << "without symbology";
}

}  // namespace
}  // namespace tedavis::draw::test_billboard_sheet
