#include "render_core/draw/data/solid_mesh.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_solid_mesh {
namespace {

using test_support::SolidRoomOfTest;

const glm::dvec3 kOrigin(4e6, 1e6, 4.5e6);

void add_cube(SolidMesh& mesh, double side) {
    const auto at = [&](int n) { return kOrigin + side * glm::dvec3(n & 1, n >> 1 & 1, n >> 2 & 1); };
    mesh.quad(at(0), at(2), at(3), at(1));
    mesh.quad(at(4), at(5), at(7), at(6));
    mesh.quad(at(0), at(1), at(5), at(4));
    mesh.quad(at(2), at(6), at(7), at(3));
    mesh.quad(at(0), at(4), at(6), at(2));
    mesh.quad(at(1), at(3), at(7), at(5));
}

TEST(SolidMesh, QuadsFaceWhereTheirCornersRunRound) {
    SolidRoomOfTest room;
    room.mesh.begin(kOrigin);
    room.mesh.set_color({10, 20, 30});
    add_cube(room.mesh, 8);
    ASSERT_TRUE(room.mesh.add_to(room.batch));
    const SolidPiece& piece = room.batch.pieces()[0];
    EXPECT_NEAR(test_support::volume_m3(room.batch, piece), 512, 1e-6);
    EXPECT_EQ(test_support::open_edges(room.batch, piece), 0u);
    EXPECT_EQ(piece.vertices, 24u) << "every side is flat";
    EXPECT_EQ(room.batch.vertices()[0].rgba[1], 20);
}

TEST(SolidMesh, AQuadWithoutAreaIsLeftOut) {
    SolidRoomOfTest room;
    room.mesh.begin(kOrigin);
    room.mesh.quad(kOrigin, kOrigin, kOrigin, kOrigin);
    EXPECT_EQ(room.mesh.vertex_count(), 0u);
    EXPECT_TRUE(room.mesh.is_whole());
}

TEST(SolidMesh, AFullMeshIsNotAddedAtAll) {
    SolidRoomOfTest room;
    room.mesh.begin(kOrigin);
    for (std::uint32_t n = 0; n <= SolidMesh::kVertices; ++n) static_cast<void>(room.mesh.vertex(kOrigin, {0, 0, 1}));
    EXPECT_FALSE(room.mesh.is_whole());
    EXPECT_FALSE(room.mesh.add_to(room.batch));
    EXPECT_EQ(room.batch.pieces().size(), 0u);
    room.mesh.begin(kOrigin);
    add_cube(room.mesh, 1);
    EXPECT_TRUE(room.mesh.add_to(room.batch));
}

TEST(SolidMesh, ASmallArenaIsRefused) {
    std::vector<unsigned char> block(SolidMesh::bytes_needed() / 2);
    base::Arena arena(block.data(), block.size());
    SolidMesh mesh;
    EXPECT_FALSE(mesh.start(arena));
}

}  // namespace
}  // namespace tedavis::draw::test_solid_mesh
