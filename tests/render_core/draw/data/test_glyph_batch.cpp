#include "render_core/draw/data/glyph_batch.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

namespace tedavis::draw::test_glyph_batch {
namespace {

TEST(GlyphBatch, RunsFollowEachOtherInOneList) {
    std::vector<GlyphInstance> room(10);
    GlyphBatch batch(room);
    base::Span<GlyphInstance> first = batch.add(GlyphShape::arrow, GlyphFacing::up, false, 3);
    ASSERT_EQ(first.size(), 3u);
    for (GlyphInstance& glyph : first) glyph = make_glyph({1, 2, 3}, {4, 5, 6}, {1, 0, 0}, {7, 8, 9, 255});
    ASSERT_EQ(batch.add(GlyphShape::ring, GlyphFacing::eye, true, 7).size(), 7u);
    EXPECT_EQ(batch.instances().size(), 10u);
    ASSERT_EQ(batch.runs().size(), 2u);
    EXPECT_EQ(batch.runs()[1].first, 3u);
    EXPECT_EQ(batch.runs()[1].shape, GlyphShape::ring);
    EXPECT_TRUE(batch.runs()[1].is_transparent);
    EXPECT_EQ(batch.of(batch.runs()[0])[2].size_m, glm::vec3(4, 5, 6));
    EXPECT_TRUE(batch.add(GlyphShape::ring, GlyphFacing::eye, true, 0).empty());
    EXPECT_EQ(batch.use().refused, 0u);
}

TEST(GlyphBatch, WhatDoesNotFitIsLeftOutWhole) {
    std::vector<GlyphInstance> room(10);
    GlyphBatch batch(room);
    ASSERT_EQ(batch.add(GlyphShape::arrow, GlyphFacing::up, false, 8).size(), 8u);
    EXPECT_TRUE(batch.add(GlyphShape::arrow, GlyphFacing::up, false, 3).empty());
    EXPECT_EQ(batch.use().refused, 3u);
    EXPECT_EQ(batch.instances().size(), 8u);
    batch.clear();
    EXPECT_TRUE(batch.runs().empty());
    EXPECT_EQ(batch.use().refused, 3u) << "refusals stay";
    EXPECT_EQ(batch.add(GlyphShape::arrow, GlyphFacing::up, false, 10).size(), 10u);
    std::vector<GlyphInstance> large(2 * kMaxGlyphRuns);
    GlyphBatch many(large);
    for (std::size_t n = 0; n < kMaxGlyphRuns; ++n) EXPECT_EQ(many.add(GlyphShape::box, GlyphFacing::up, false, 1).size(), 1u);
    EXPECT_TRUE(many.add(GlyphShape::box, GlyphFacing::up, false, 1).empty()) << "more runs than it holds";
}

TEST(GlyphBatch, MovesToWhereAnotherEyeStands) {
    std::vector<GlyphInstance> room(4);
    GlyphBatch batch(room);
    for (GlyphInstance& glyph : batch.add(GlyphShape::sphere, GlyphFacing::eye, false, 3))
        glyph = make_glyph({10, 20, 30}, {1, 1, 1}, {1, 0, 0}, {});
    room[3].place = {7, 7, 7};
    batch.move({-1, 2, 0.5f});
    for (const GlyphInstance& glyph : batch.instances()) EXPECT_EQ(glyph.place, glm::vec3(9, 22, 30.5f));
    EXPECT_EQ(room[3].place, glm::vec3(7, 7, 7)) << "what is not in it stays";
}

TEST(GlyphBatch, DirectionsKeepWithinHalfADegree) {
    for (int n = 0; n < 1000; ++n) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(std::sin(n * 1.1), std::cos(n * 0.7), std::sin(n * 0.3 + 1)));
        const GlyphInstance glyph = make_glyph({}, {1, 1, 1}, direction, {});
        const glm::dvec3 kept(glyph.direction[0], glyph.direction[1], glyph.direction[2]);
        EXPECT_GT(glm::dot(glm::normalize(kept), direction), std::cos(0.5 * 3.14159 / 180));
        EXPECT_EQ(glyph.direction[3], 0);
    }
    EXPECT_EQ(make_glyph({}, {1, 1, 1}, glm::dvec3(0), {}).direction[3], 127) << "none: upright";
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_batch
