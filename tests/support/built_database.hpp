/// A terrain database built in memory from a raster, opened as the display opens it, and the meshes of its chunks.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <utility>
#include <vector>

#include "host_sim/terrain_builder/tdb_image.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "tests/support/memory_bytes.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis::test_support {

struct BuiltDatabase {
    std::vector<std::uint8_t> image;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(1 << 22);
    MemoryBytes bytes;
    base::Arena arena;
    terrain::TerrainDatabase database;

    explicit BuiltDatabase(host_sim::Raster raster) : BuiltDatabase(host_sim::make_model(std::move(raster), {})) {}
    explicit BuiltDatabase(const host_sim::TerrainModel& model)
        : image(host_sim::make_tdb(model, {})), bytes(image), arena(memory.data(), memory.size()) {
        auto opened = terrain::TerrainDatabase::open(bytes, arena);
        EXPECT_TRUE(opened.ok());
        if (opened.ok()) database = opened.value();
    }
    BuiltDatabase(const BuiltDatabase&) = delete;
    BuiltDatabase& operator=(const BuiltDatabase&) = delete;

    [[nodiscard]] std::vector<terrain::ChunkVertex> vertices(terrain::ChunkIndex chunk) const {
        const terrain::ChunkEntry& entry = database.entry(chunk);
        std::vector<terrain::ChunkVertex> result(entry.vertex_count);
        std::memcpy(result.data(), image.data() + entry.offset, result.size() * sizeof(terrain::ChunkVertex));
        return result;
    }
};

/// A lattice post of the whole database.
using LatticePost = std::pair<std::int64_t, std::int64_t>;

/// The triangles of one chunk beside a given set of coarser neighbours, with what a topologist asks of them.
struct BuiltMesh {
    std::vector<terrain::ChunkVertex> vertices;
    std::vector<std::uint16_t> indices;
    std::int64_t west = 0, north = 0, side = 0;

    BuiltMesh(const BuiltDatabase& built, terrain::ChunkIndex chunk, std::uint8_t coarser) : vertices(built.vertices(chunk)) {
        const terrain::ChunkEntry& e = built.database.entry(chunk);
        side = std::int64_t{terrain::kChunkCells} << e.level;
        west = e.i * side;
        north = e.j * side;
        static terrain::ChunkMeshScratch scratch;
        std::vector<std::uint16_t> out(3 * terrain::kMaxChunkTriangles);
        const terrain::FileHeader& h = built.database.header();
        const terrain::MeshCount count =
            terrain::build_chunk_indices({vertices.data(), vertices.size()}, {e.level, e.i, e.j, h.columns - 1, h.rows - 1},
                                         coarser, scratch, {out.data(), out.size()});
        EXPECT_TRUE(count.sound);
        indices.assign(out.begin(), out.begin() + count.indices);
    }
    [[nodiscard]] LatticePost at(std::uint16_t n) const { return {west + vertices[n].i, north + vertices[n].j}; }

    /// Directed edges that no other triangle uses the other way.
    [[nodiscard]] std::set<std::pair<LatticePost, LatticePost>> outline() const {
        std::set<std::pair<LatticePost, LatticePost>> open;
        for (std::size_t n = 0; n < indices.size(); n += 3)
            for (int k = 0; k < 3; ++k) {
                const LatticePost a = at(indices[n + k]), b = at(indices[n + (k + 1) % 3]);
                EXPECT_EQ(open.count({a, b}), 0u) << "edge used twice in one direction";
                if (open.erase({b, a}) == 0) open.insert({a, b});
            }
        return open;
    }
    /// Twice the area in cells; every triangle must be counter-clockwise seen from above.
    [[nodiscard]] std::int64_t twice_area() const {
        std::int64_t sum = 0;
        for (std::size_t n = 0; n < indices.size(); n += 3) {
            const LatticePost a = at(indices[n]), b = at(indices[n + 1]), c = at(indices[n + 2]);
            const std::int64_t area = (c.first - a.first) * (b.second - a.second) - (b.first - a.first) * (c.second - a.second);
            EXPECT_GT(area, 0) << "not counter-clockwise from above";
            sum += area;
        }
        return sum;
    }
    [[nodiscard]] bool on_square(const LatticePost& a, const LatticePost& b) const {
        return (a.first == b.first && (a.first == west || a.first == west + side)) ||
               (a.second == b.second && (a.second == north || a.second == north + side));
    }
    /// Posts that the mesh shows on one side of its square.
    [[nodiscard]] std::set<std::int64_t> border(terrain::EdgeBit edge) const {
        std::set<std::int64_t> posts;
        for (const auto& [a, b] : outline())
            for (const LatticePost& p : {a, b}) {
                if (edge == terrain::kEdgeNorth && p.second == north) posts.insert(p.first);
                if (edge == terrain::kEdgeSouth && p.second == north + side) posts.insert(p.first);
                if (edge == terrain::kEdgeWest && p.first == west) posts.insert(p.second);
                if (edge == terrain::kEdgeEast && p.first == west + side) posts.insert(p.second);
            }
        return posts;
    }
};

}  // namespace tedavis::test_support
