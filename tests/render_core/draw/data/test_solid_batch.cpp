#include "render_core/draw/data/solid_batch.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_solid_batch {
namespace {

using test_support::SolidRoomOfTest;

struct Triangle {
    std::vector<SolidVertex> vertices{solid_vertex({0, 0, 0}, {0, 0, 1}, {255, 0, 0}),
                                      solid_vertex({10, 0, 0}, {0, 0, 1}, {255, 0, 0}),
                                      solid_vertex({0, 10, 0}, {0, 0, 1}, {255, 0, 0})};
    std::vector<std::uint16_t> indices{0, 1, 2};

    bool add_to(SolidBatch& batch, const glm::dvec3& origin) const {
        return batch.add(origin, {vertices.data(), vertices.size()}, {indices.data(), indices.size()});
    }
};

glm::dvec3 place_of(const SolidBatch& batch, const SolidPiece& piece, std::uint32_t index) {
    const std::uint16_t vertex = batch.indices()[piece.first_index + index];
    return piece.anchor + glm::dvec3(batch.vertices()[piece.first_vertex + vertex].place_m);
}

TEST(SolidBatch, NormalsAndColorsSurviveTheirCodes) {
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3f, -0.8f, 0.52f));
    const SolidVertex vertex = solid_vertex({1, 2, 3}, normal, {1, 2, 3, 4}, scene::Uncertainty::from_level(0.5));
    for (int n = 0; n < 3; ++n) EXPECT_NEAR((static_cast<float>(vertex.normal[n]) - 127) / 127, normal[n], 0.5f / 127 + 1e-6f);
    EXPECT_EQ(vertex.uncertainty, scene::Uncertainty::from_level(0.5).code());
    EXPECT_EQ(vertex.rgba[3], 4);
    const SolidVertex flat = solid_vertex({0, 0, 0}, {0, 0, 0}, {});
    for (const std::uint8_t code : flat.normal) EXPECT_EQ(code, 127) << "no normal";
}

TEST(SolidBatch, MeshesOfOneLookShareAPiece) {
    SolidRoomOfTest room;
    const Triangle triangle;
    const glm::dvec3 first(4e6, 1e6, 4e6), second = first + glm::dvec3(500, -20, 3);
    EXPECT_TRUE(triangle.add_to(room.batch, first) && triangle.add_to(room.batch, second));
    ASSERT_EQ(room.batch.pieces().size(), 1u);
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_EQ(piece.indices, 6u);
    EXPECT_LT(glm::distance(place_of(room.batch, piece, 3), second), 1e-4);
    EXPECT_LT(glm::distance(place_of(room.batch, piece, 4), second + glm::dvec3(10, 0, 0)), 1e-4);
    EXPECT_GE(static_cast<double>(piece.radius_m), glm::distance(first, second));
}

TEST(SolidBatch, AnotherLookAndADistantPlaceBeginPieces) {
    SolidRoomOfTest room;
    const Triangle triangle;
    SolidLook look;
    room.batch.set_look(look, 0);
    EXPECT_TRUE(triangle.add_to(room.batch, {4e6, 0, 0}));
    room.batch.set_look(look, 0);
    EXPECT_TRUE(triangle.add_to(room.batch, {4e6, 10, 0}));
    EXPECT_EQ(room.batch.pieces().size(), 1u) << "the same look again begins nothing";
    look.ghost = 0.5f;
    room.batch.set_look(look, 0);
    EXPECT_TRUE(triangle.add_to(room.batch, {4e6, 20, 0}));
    EXPECT_EQ(room.batch.pieces().size(), 2u);
    room.batch.set_look(look, 7);
    EXPECT_TRUE(triangle.add_to(room.batch, {4e6, 20, 0}));
    EXPECT_EQ(room.batch.pieces().size(), 3u) << "data of another time age otherwise";
    EXPECT_TRUE(triangle.add_to(room.batch, {4e6, 20 + SolidBatch::kFarthestFromAnchor_m, 0}));
    EXPECT_EQ(room.batch.pieces().size(), 4u);
}

TEST(SolidBatch, EveryMixedMeshIsAPieceOfItsOwn) {
    SolidRoomOfTest room;
    SolidLook look;
    look.is_mixed = true;
    room.batch.set_look(look, 0);
    const Triangle triangle;
    for (int n = 0; n < 3; ++n) EXPECT_TRUE(triangle.add_to(room.batch, {4e6, 0, 0}));
    EXPECT_EQ(room.batch.pieces().size(), 3u);
}

TEST(SolidBatch, WhatDoesNotFitIsLeftOutWholeAndCounted) {
    SolidRoomOfTest room(7, 2);
    const Triangle triangle;
    EXPECT_TRUE(triangle.add_to(room.batch, {0, 0, 0}) && triangle.add_to(room.batch, {0, 0, 0}));
    EXPECT_FALSE(triangle.add_to(room.batch, {0, 0, 0})) << "one vertex is left";
    EXPECT_EQ(room.batch.use().refused, 1u);
    EXPECT_EQ(room.batch.vertices().size(), 6u);
    room.batch.clear();
    EXPECT_EQ(room.batch.pieces().size(), 0u);
    EXPECT_TRUE(triangle.add_to(room.batch, {0, 0, 0}) && triangle.add_to(room.batch, {40'000, 0, 0}));
    room.batch.clear();
    SolidRoomOfTest few(100, 1);
    EXPECT_TRUE(triangle.add_to(few.batch, {0, 0, 0}));
    EXPECT_FALSE(triangle.add_to(few.batch, {40'000, 0, 0})) << "no piece is left";
}

TEST(SolidBatch, IndicesStayWithinSixteenBits) {
    SolidRoomOfTest room(3 * 22'000);
    const Triangle triangle;
    for (int n = 0; n < 22'000; ++n) ASSERT_TRUE(triangle.add_to(room.batch, {0, 0, 0}));
    ASSERT_EQ(room.batch.pieces().size(), 2u);
    EXPECT_EQ(room.batch.pieces()[0].vertices, SolidBatch::kMaxPieceVertices);
    EXPECT_EQ(room.batch.pieces()[1].first_vertex, SolidBatch::kMaxPieceVertices);
}

}  // namespace
}  // namespace tedavis::draw::test_solid_batch
