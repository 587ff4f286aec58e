#include "host_sim/terrain_builder/tdb_image.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>

#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/height_query.hpp"
#include "tests/support/memory_bytes.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis {
namespace {

using namespace terrain;
using host_sim::BuildOptions;

struct BuiltDatabase {
    std::vector<std::uint8_t> image;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(1 << 22);
    test_support::MemoryBytes bytes;
    base::Arena arena;
    TerrainDatabase database;

    explicit BuiltDatabase(host_sim::Raster raster) : BuiltDatabase(host_sim::make_model(std::move(raster), {})) {}
    explicit BuiltDatabase(const host_sim::TerrainModel& model)
        : image(host_sim::make_tdb(model, {})), bytes(image), arena(memory.data(), memory.size()) {
        auto opened = TerrainDatabase::open(bytes, arena);
        EXPECT_TRUE(opened.ok()) << to_string(opened.error().error);
        database = opened.value();
    }
    std::vector<ChunkVertex> vertices(ChunkIndex chunk) const {
        const ChunkEntry& entry = database.entry(chunk);
        std::vector<ChunkVertex> result(entry.vertex_count);
        std::memcpy(result.data(), image.data() + entry.offset, result.size() * sizeof(ChunkVertex));
        return result;
    }
};

using Point = std::pair<std::int64_t, std::int64_t>;

struct Mesh {
    std::vector<ChunkVertex> vertices;
    std::vector<std::uint16_t> indices;
    std::int64_t west, north, side;

    Mesh(const BuiltDatabase& built, ChunkIndex chunk, std::uint8_t coarser) : vertices(built.vertices(chunk)) {
        const ChunkEntry& e = built.database.entry(chunk);
        side = std::int64_t{kChunkCells} << e.level;
        west = e.i * side;
        north = e.j * side;
        static ChunkMeshScratch scratch;
        std::vector<std::uint16_t> out(3 * kMaxChunkTriangles);
        const auto& h = built.database.header();
        const MeshCount count =
            build_chunk_indices({vertices.data(), vertices.size()}, {e.level, e.i, e.j, h.columns - 1, h.rows - 1}, coarser,
                                scratch, {out.data(), out.size()});
        EXPECT_TRUE(count.sound);
        indices.assign(out.begin(), out.begin() + count.indices);
    }
    Point at(std::uint16_t n) const { return {west + vertices[n].i, north + vertices[n].j}; }

    /// Directed edges that no other triangle uses the other way: the mesh's outline.
    std::set<std::pair<Point, Point>> outline() const {
        std::set<std::pair<Point, Point>> open;
        for (std::size_t n = 0; n < indices.size(); n += 3)
            for (int k = 0; k < 3; ++k) {
                const Point a = at(indices[n + k]), b = at(indices[n + (k + 1) % 3]);
                EXPECT_EQ(open.count({a, b}), 0u) << "edge used twice in one direction";
                if (open.erase({b, a}) == 0) open.insert({a, b});
            }
        return open;
    }
    std::int64_t twice_area() const {
        std::int64_t sum = 0;
        for (std::size_t n = 0; n < indices.size(); n += 3) {
            const Point a = at(indices[n]), b = at(indices[n + 1]), c = at(indices[n + 2]);
            const std::int64_t area = (c.first - a.first) * (b.second - a.second) - (b.first - a.first) * (c.second - a.second);
            EXPECT_GT(area, 0) << "not counter-clockwise from above";
            sum += area;
        }
        return sum;
    }
    /// Posts on one side of the square, in order.
    std::set<std::int64_t> border(EdgeBit edge) const {
        std::set<std::int64_t> posts;
        for (const auto& [a, b] : outline()) {
            for (const Point& p : {a, b}) {
                if (edge == kEdgeNorth && p.second == north) posts.insert(p.first);
                if (edge == kEdgeSouth && p.second == north + side) posts.insert(p.first);
                if (edge == kEdgeWest && p.first == west) posts.insert(p.second);
                if (edge == kEdgeEast && p.first == west + side) posts.insert(p.second);
            }
        }
        return posts;
    }
};

TEST(TdbImage, EveryMeshCoversItsSquareOnceForEveryCombinationOfCoarserNeighbours) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 257));
    ASSERT_GE(built.database.levels(), 3u);
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk)
        for (std::uint8_t mask = 0; mask < 16; ++mask) {
            const Mesh mesh(built, chunk, mask);
            EXPECT_EQ(mesh.twice_area(), 2 * mesh.side * mesh.side);
            for (const auto& [a, b] : mesh.outline())
                EXPECT_TRUE((a.first == b.first && (a.first == mesh.west || a.first == mesh.west + mesh.side)) ||
                            (a.second == b.second && (a.second == mesh.north || a.second == mesh.north + mesh.side)))
                    << "T-junction or hole inside chunk " << chunk << " mask " << int{mask};
        }
}

TEST(TdbImage, BordersOfOneLevelAgree) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 257));
    for (std::uint32_t level = 0; level < built.database.levels(); ++level)
        for (std::uint32_t j = 0; j < built.database.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i + 1 < built.database.grid_columns(level); ++i)
                for (const std::uint8_t west_mask : {0, 1, 4, 8, 13})
                    for (const std::uint8_t east_mask : {0, 1, 4, 2, 7}) {
                        const Mesh west(built, built.database.at(level, i, j), west_mask),
                            east(built, built.database.at(level, i + 1, j), east_mask);
                        EXPECT_EQ(west.border(kEdgeEast), east.border(kEdgeWest)) << level << ": " << i << "," << j;
                    }
}

TEST(TdbImage, BorderTowardsACoarserChunkIsTheCoarserBorder) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 257));
    const TerrainDatabase& db = built.database;
    int compared = 0, finer_without_mask = 0;
    for (std::uint32_t level = 0; level + 1 < db.levels(); ++level)
        for (std::uint32_t j = 0; j < db.grid_rows(level); ++j)
            for (std::uint32_t i = 1; i + 1 < db.grid_columns(level); i += 2) {
                const ChunkIndex coarse = db.at(level + 1, (i + 1) / 2, j / 2);
                ASSERT_NE(coarse, kNoChunk);
                const Mesh fine(built, db.at(level, i, j), kEdgeEast), plain(built, db.at(level, i, j), 0);
                std::set<std::int64_t> expected;
                for (const std::int64_t post : Mesh(built, coarse, 0).border(kEdgeWest))
                    if (post >= fine.north && post <= fine.north + fine.side) expected.insert(post);
                EXPECT_EQ(fine.border(kEdgeEast), expected);
                ++compared;
                finer_without_mask += plain.border(kEdgeEast) != expected ? 1 : 0;
            }
    EXPECT_GE(compared, 4);
    EXPECT_GT(finer_without_mask, 0) << "negative control: without the mask there must be T-junctions";
}

TEST(TdbImage, SharedVerticesAreBitEqualInEveryChunkThatHasThem) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 193));
    std::map<Point, std::array<double, 3>> positions;
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk) {
        const ChunkEntry& e = built.database.entry(chunk);
        const std::int64_t side = std::int64_t{kChunkCells} << e.level;
        for (const ChunkVertex& v : built.vertices(chunk)) {
            const std::array<double, 3> p{e.centre_m[0] + v.x, e.centre_m[1] + v.y, e.centre_m[2] + v.z};
            const auto [found, inserted] = positions.try_emplace({e.i * side + v.i, e.j * side + v.j}, p);
            if (!inserted) {
                EXPECT_EQ(found->second, p);
            }
        }
    }
}

TEST(TdbImage, LevelZeroIsTheTrueSurfaceAndCoarserLevelsKeepTheirTolerance) {
    const BuiltDatabase built(test_support::make_rough_raster(257, 257));
    const auto& h = built.database.header();
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk) {
        const ChunkEntry& e = built.database.entry(chunk);
        EXPECT_LE(e.above_m, h.tolerance_m[e.level] + 0.02f);
        EXPECT_LE(e.below_m, h.tolerance_m[e.level] + 0.02f);
        EXPECT_LE(std::max(e.above_m, e.below_m), e.bound_m + 0.001f);
        if (e.level > 0) {
            EXPECT_LT(e.triangle_count, 2u * kChunkCells * kChunkCells * (1u << (2 * e.level)));
        }
    }
}

TEST(TdbImage, VoidCellsHaveNoTrianglesAndTheirValueDoesNotMatter) {
    const auto with_hole = [](float value) {
        host_sim::Raster raster = test_support::make_rough_raster(129, 129);
        for (std::uint32_t j = 40; j < 60; ++j)
            for (std::uint32_t i = 50; i < 75; ++i) {
                raster.height_m[raster.at(i, j)] = value;
                raster.post_class[raster.at(i, j)] = PostClass::void_;
            }
        raster.void_posts = 20 * 25;
        return raster;
    };
    const BuiltDatabase built(with_hole(NAN));
    for (ChunkIndex chunk = 0; chunk < built.database.chunk_count(); ++chunk) {
        const Mesh mesh(built, chunk, 0);
        for (std::size_t n = 0; n < mesh.indices.size(); n += 3)
            for (int k = 0; k < 3; ++k) {
                const Point p = mesh.at(mesh.indices[n + k]);
                EXPECT_FALSE(p.first >= 50 && p.first < 75 && p.second >= 40 && p.second < 60);
            }
    }
    const ChunkIndex top = built.database.at(built.database.levels() - 1, 0, 0);
    EXPECT_EQ(Mesh(built, top, 0).twice_area(), 2 * (128 * 128 - 26 * 21));
}

TEST(TdbImage, HeightQueryReturnsPostsAndBothTriangles) {
    const host_sim::Raster raster = test_support::make_rough_raster(200, 150);
    const BuiltDatabase built(raster);
    std::vector<std::uint8_t> memory(1 << 20);
    base::Arena arena(memory.data(), memory.size());
    HeightQuery query;
    ASSERT_TRUE(query.start(built.database, arena));
    const auto ask = [&](double i, double j) {
        return query.at(base::radians(raster.north_deg - j * raster.step_lat_deg),
                        base::radians(raster.west_deg + i * raster.step_lon_deg));
    };
    const auto post = [&](std::uint32_t i, std::uint32_t j) { return double{raster.height_m[raster.at(i, j)]}; };
    for (const auto& [i, j] : {std::pair{0u, 0u}, {63u, 64u}, {64u, 64u}, {130u, 77u}, {199u, 149u}})
        EXPECT_NEAR(ask(i, j).height.m, post(i, j), 1e-3);
    EXPECT_NEAR(ask(64.25, 70.25).height.m, 0.5 * post(64, 70) + 0.25 * post(65, 70) + 0.25 * post(64, 71), 1e-3);
    EXPECT_NEAR(ask(64.75, 70.75).height.m, 0.5 * post(65, 71) + 0.25 * post(65, 70) + 0.25 * post(64, 71), 1e-3);
    EXPECT_EQ(ask(-1, 5).status, HeightStatus::outside);
    EXPECT_EQ(ask(200, 5).status, HeightStatus::outside);
}

TEST(TdbImage, EveryFlippedBitIsFound) {
    const BuiltDatabase built(test_support::make_rough_raster(70, 66));
    std::vector<std::uint8_t> memory(1 << 22);
    for (std::size_t position = 0; position < built.image.size(); position += 97) {
        std::vector<std::uint8_t> damaged = built.image;
        damaged[position] ^= static_cast<std::uint8_t>(1u << (position % 8));
        test_support::MemoryBytes bytes(damaged);
        base::Arena arena(memory.data(), memory.size());
        auto opened = TerrainDatabase::open(bytes, arena);
        bool found = !opened.ok();
        std::vector<std::uint8_t> payload(1 << 20);
        for (ChunkIndex chunk = 0; !found && chunk < opened.value().chunk_count(); ++chunk)
            found = opened.value().read_chunk(chunk, {payload.data(), payload.size()}).error != TdbError::none;
        EXPECT_TRUE(found) << "bit at byte " << position;
    }
}

}  // namespace
}  // namespace tedavis
