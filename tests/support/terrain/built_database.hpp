/// A terrain database built in memory from a raster, opened as the display opens it, and the meshes of its chunks.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "tests/support/files/memory_bytes.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_support {

struct BuiltDatabase {
    std::vector<std::uint8_t> image;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(1 << 23);
    MemoryBytes bytes;
    base::Arena arena;
    terrain::TerrainDatabase database;

    explicit BuiltDatabase(const host_sim::Raster& raster, const host_sim::BuildOptions& options = {})
        : BuiltDatabase(build_image(raster, options)) {}
    explicit BuiltDatabase(std::vector<std::uint8_t> file)
        : image(std::move(file)), bytes(image), arena(memory.data(), memory.size()) {
        auto opened = terrain::TerrainDatabase::open(bytes, arena);
        EXPECT_TRUE(opened.ok());
        if (opened.ok()) database = opened.value();
    }
    BuiltDatabase(const BuiltDatabase&) = delete;
    BuiltDatabase& operator=(const BuiltDatabase&) = delete;

    [[nodiscard]] const terrain::Lattice& lattice() const { return database.lattice(); }
    /// Of all levels, finest first, row by row.
    [[nodiscard]] std::vector<terrain::ChunkKey> chunks() const {
        std::vector<terrain::ChunkKey> keys;
        for (std::uint32_t level = 0; level < database.levels(); ++level)
            for (std::uint32_t j = 0; j < lattice().grid_rows(level); ++j)
                for (std::uint32_t i = 0; i < lattice().grid_columns(level); ++i) keys.push_back({level, i, j});
        return keys;
    }
    [[nodiscard]] terrain::ChunkEntry entry(const terrain::ChunkKey& key) const {
        const auto page = std::make_unique<terrain::DirectoryPage>();
        EXPECT_EQ(database.read_page(lattice().page_index(key), *page).error, terrain::TdbError::none);
        return page->entries[terrain::Lattice::index_in_page(key)];
    }
    [[nodiscard]] std::vector<terrain::ChunkVertex> vertices(const terrain::ChunkEntry& entry) const {
        std::vector<terrain::ChunkVertex> result(entry.vertex_count);
        std::memcpy(result.data(), image.data() + entry.payload.offset, result.size() * sizeof(terrain::ChunkVertex));
        return result;
    }
    /// Empty for a regular chunk.
    [[nodiscard]] std::vector<std::uint16_t> stored_indices(const terrain::ChunkEntry& entry) const {
        const std::size_t vertex_bytes = entry.vertex_count * sizeof(terrain::ChunkVertex);
        std::vector<std::uint16_t> result((entry.payload.bytes - vertex_bytes) / sizeof(std::uint16_t));
        if (!result.empty())
            std::memcpy(result.data(), image.data() + entry.payload.offset + vertex_bytes, result.size() * sizeof(std::uint16_t));
        return result;
    }
};

/// A lattice post of the whole database.
using LatticePost = std::pair<std::int64_t, std::int64_t>;

/// The triangles of one chunk beside a given set of coarser neighbours, with what a topologist asks of them.
struct BuiltMesh {
    terrain::ChunkEntry entry;
    std::vector<terrain::ChunkVertex> vertices;
    std::vector<std::uint16_t> indices;
    terrain::PostRange posts;

    BuiltMesh(const BuiltDatabase& built, const terrain::ChunkKey& key, std::uint8_t coarser)
        : entry(built.entry(key)), vertices(built.vertices(entry)), posts(built.lattice().posts_of(key)) {
        const std::vector<std::uint16_t> stored = built.stored_indices(entry);
        const auto scratch = std::make_unique<terrain::ChunkMeshScratch>();
        std::vector<std::uint16_t> out(3 * terrain::kMaxChunkTriangles);
        const terrain::MeshCount count =
            terrain::build_chunk_indices(entry, {vertices.data(), vertices.size()}, {stored.data(), stored.size()}, coarser,
                                         *scratch, {out.data(), out.size()});
        EXPECT_TRUE(count.sound);
        indices.assign(out.begin(), out.begin() + count.indices);
    }
    [[nodiscard]] LatticePost at(std::uint16_t n) const { return {posts.i0 + vertices[n].i, posts.j0 + vertices[n].j}; }

    /// Directed edges that no other triangle uses the other way.
    [[nodiscard]] std::set<std::pair<LatticePost, LatticePost>> outline() const {
        std::set<std::pair<LatticePost, LatticePost>> open;
        for (std::size_t n = 0; n < indices.size(); n += 3)
            for (std::size_t k = 0; k < 3; ++k) {
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
    /// Posts that the mesh shows on one side of its rectangle, along it.
    [[nodiscard]] std::set<std::int64_t> border(terrain::EdgeBit edge) const {
        std::set<std::int64_t> shown;
        for (const auto& [a, b] : outline())
            for (const LatticePost& p : {a, b}) {
                if (edge == terrain::kEdgeNorth && p.second == posts.j0) shown.insert(p.first);
                if (edge == terrain::kEdgeSouth && p.second == posts.j1) shown.insert(p.first);
                if (edge == terrain::kEdgeWest && p.first == posts.i0) shown.insert(p.second);
                if (edge == terrain::kEdgeEast && p.first == posts.i1) shown.insert(p.second);
            }
        return shown;
    }
};

}  // namespace tedavis::test_support
