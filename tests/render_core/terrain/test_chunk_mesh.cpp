#include "render_core/terrain/chunk_mesh.hpp"

#include <gtest/gtest.h>

#include "tests/support/built_database.hpp"

namespace tedavis::terrain {
namespace {

using test_support::BuiltDatabase;
using test_support::BuiltMesh;

const BuiltDatabase& rough() {
    static const BuiltDatabase built(test_support::make_rough_raster(161, 193));
    return built;
}

TEST(ChunkMesh, CoversItsSquareOnceForEveryCombinationOfCoarserNeighbours) {
    ASSERT_GE(rough().database.levels(), 3u);
    for (ChunkIndex chunk = 0; chunk < rough().database.chunk_count(); ++chunk) {
        if ((rough().database.entry(chunk).flags & kChunkHasOutside) != 0) continue;
        for (std::uint8_t mask = 0; mask < 16; ++mask) {
            const BuiltMesh mesh(rough(), chunk, mask);
            EXPECT_EQ(mesh.twice_area(), 2 * mesh.side * mesh.side);
            for (const auto& [a, b] : mesh.outline())
                EXPECT_TRUE(mesh.on_square(a, b)) << "T-junction or hole inside chunk " << chunk << " mask " << int{mask};
        }
    }
}

TEST(ChunkMesh, BordersOfOneLevelAgreeWhateverTheirOtherNeighbours) {
    const TerrainDatabase& db = rough().database;
    for (std::uint32_t level = 0; level < db.levels(); ++level)
        for (std::uint32_t j = 0; j < db.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i + 1 < db.grid_columns(level); ++i)
                for (const std::uint8_t west_mask : {0, 1, 4, 8, 13})
                    for (const std::uint8_t east_mask : {0, 1, 4, 2, 7})
                        EXPECT_EQ(BuiltMesh(rough(), db.at(level, i, j), west_mask).border(kEdgeEast),
                                  BuiltMesh(rough(), db.at(level, i + 1, j), east_mask).border(kEdgeWest))
                            << level << ": " << i << "," << j;
}

TEST(ChunkMesh, BorderTowardsACoarserChunkIsTheCoarserBorder) {
    const TerrainDatabase& db = rough().database;
    int compared = 0, different_without_mask = 0;
    for (std::uint32_t level = 0; level + 1 < db.levels(); ++level)
        for (std::uint32_t j = 0; j < db.grid_rows(level); ++j)
            for (std::uint32_t i = 1; i + 1 < db.grid_columns(level); i += 2) {
                const ChunkIndex coarse = db.at(level + 1, (i + 1) / 2, j / 2);
                const BuiltMesh fine(rough(), db.at(level, i, j), kEdgeEast), plain(rough(), db.at(level, i, j), 0);
                std::set<std::int64_t> expected;
                for (const std::int64_t post : BuiltMesh(rough(), coarse, 0).border(kEdgeWest))
                    if (post >= fine.north && post <= fine.north + fine.side) expected.insert(post);
                EXPECT_EQ(fine.border(kEdgeEast), expected);
                ++compared;
                different_without_mask += plain.border(kEdgeEast) != expected ? 1 : 0;
            }
    EXPECT_GE(compared, 4);
    EXPECT_GT(different_without_mask, 0) << "negative control: without the mask there must be T-junctions";
}

TEST(ChunkMesh, UnitCellsHaveTheTrueSurfacesDiagonal) {
    const BuiltMesh mesh(rough(), 0, 0);
    int diagonals = 0;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3)
        for (int k = 0; k < 3; ++k) {
            const auto a = mesh.at(mesh.indices[n + k]), b = mesh.at(mesh.indices[n + (k + 1) % 3]);
            if (std::abs(a.first - b.first) != 1 || std::abs(a.second - b.second) != 1) continue;
            EXPECT_EQ((a.first - b.first) * (a.second - b.second), -1) << "the other diagonal";
            ++diagonals;
        }
    EXPECT_GT(diagonals, 1000);
}

TEST(ChunkMesh, NothingIsDrawnBeyondTheRaster) {
    const BuiltDatabase built(test_support::make_rough_raster(70, 45));
    const ChunkIndex corner = built.database.at(0, 2, 1);
    const BuiltMesh mesh(built, corner, 0);
    EXPECT_FALSE(mesh.indices.empty());
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
        std::int64_t least_i = INT64_MAX, least_j = INT64_MAX;
        for (int k = 0; k < 3; ++k) {
            least_i = std::min(least_i, mesh.at(mesh.indices[n + k]).first);
            least_j = std::min(least_j, mesh.at(mesh.indices[n + k]).second);
        }
        EXPECT_LT(least_i, 69);
        EXPECT_LT(least_j, 44);
    }
}

TEST(ChunkMesh, VoidCellsHaveNoTriangles) {
    host_sim::Raster raster = test_support::make_rough_raster(129, 129);
    for (std::uint32_t j = 40; j < 60; ++j)
        for (std::uint32_t i = 50; i < 75; ++i) {
            raster.height_m[raster.at(i, j)] = NAN;
            raster.post_class[raster.at(i, j)] = PostClass::void_;
        }
    raster.void_posts = 20 * 25;
    const BuiltDatabase built(raster);
    const ChunkIndex top = built.database.at(built.database.levels() - 1, 0, 0);
    ASSERT_EQ(std::int64_t{kChunkCells} << built.database.entry(top).level, 128)
        << "the hole must not cost the coarsest level here";
    EXPECT_EQ(BuiltMesh(built, top, 0).twice_area(), 2 * (128 * 128 - 26 * 21));
}

TEST(ChunkMesh, ContradictingVerticesAndSmallOutputAreRefused) {
    std::vector<ChunkVertex> vertices = rough().vertices(0);
    const FileHeader& h = rough().database.header();
    static ChunkMeshScratch scratch;
    std::vector<std::uint16_t> out(3 * kMaxChunkTriangles);
    const ChunkPlace place{0, 0, 0, h.columns - 1, h.rows - 1};
    ASSERT_TRUE(build_chunk_indices({vertices.data(), vertices.size()}, place, 0, scratch, {out.data(), out.size()}).sound);
    EXPECT_FALSE(build_chunk_indices({vertices.data(), vertices.size()}, place, 0, scratch, {out.data(), 30}).sound);
    EXPECT_FALSE(
        build_chunk_indices({vertices.data() + 4, vertices.size() - 4}, place, 0, scratch, {out.data(), out.size()}).sound)
        << "corners are missing";
}

}  // namespace
}  // namespace tedavis::terrain
