#include "host_sim/terrain_builder/chunk_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "render_core/terrain/chunk_payload.hpp"
#include "render_core/terrain/regular_chunk.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_chunk_builder {
namespace {

using namespace terrain;
using test_support::BuildGround;

ChunkDraft regular(const BuildGround& ground, std::uint32_t i, std::uint32_t j) {
    const LatticeWindow window = ground.all();
    return make_regular_chunk(ground.plan, ground.lines, {0, i, j}, window,
                              PostPlaces(ground.plan.lattice, window.i0, window.j0, window.columns, window.rows));
}

TEST(ChunkBuilder, RegularChunksHaveEveryPostInTheirOrder) {
    const BuildGround ground(test_support::make_rough_raster(80, 70));
    for (const auto& [i, j] : {std::pair{0u, 0u}, {2u, 2u}, {1u, 2u}}) {
        const ChunkDraft draft = regular(ground, i, j);
        const PostRange posts = ground.plan.lattice.posts_of({0, i, j});
        const RegularGrid grid = regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, 0);
        ASSERT_EQ(draft.vertices.size(), grid.vertex_count());
        EXPECT_EQ(draft.entry.border_count, grid.border_count());
        EXPECT_EQ(draft.entry.triangle_count, grid.triangle_count());
        EXPECT_TRUE(draft.triangles.empty());
        for (std::uint32_t b = 0; b < grid.rows; ++b)
            for (std::uint32_t a = 0; a < grid.columns; ++a) {
                const ChunkVertex& v = draft.vertices[grid.index_of(a, b)];
                ASSERT_TRUE(v.i == a && v.j == b);
            }
    }
}

TEST(ChunkBuilder, StripsComeFirst) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    ChunkDraft draft = regular(ground, 1, 1);
    draft.entry.flags = 0;
    for (std::uint32_t n = 0; n < draft.entry.border_count; n += 3)
        draft.vertices[n].kind = static_cast<std::uint8_t>(draft.vertices[n].kind & ~4u);
    std::vector<std::uint16_t> triangles;
    const RegularGrid grid{33, 33};
    for (std::uint32_t b = 0; b < 32; ++b)
        for (std::uint32_t a = 0; a < 32; ++a) {
            const auto at = [&](std::uint32_t i, std::uint32_t j) {
                return static_cast<std::uint16_t>(grid.index_of(a + i, b + j));
            };
            for (const std::uint16_t n : {at(0, 0), at(0, 1), at(1, 0), at(1, 0), at(0, 1), at(1, 1)}) triangles.push_back(n);
        }
    set_triangles(draft, triangles);
    EXPECT_EQ(draft.entry.triangle_count, 2048);
    for (std::size_t t = 0; t < 2048; ++t) {
        const bool touches = std::any_of(&draft.triangles[3 * t], &draft.triangles[3 * t] + 3, [&](std::uint16_t n) {
            return n < draft.entry.border_count && !draft.vertices[n].stays_beside_coarser();
        });
        EXPECT_EQ(touches, t < draft.entry.strip_count);
    }
    EXPECT_GT(draft.entry.strip_count, 32);
    std::sort(triangles.begin(), triangles.end());
    std::sort(draft.triangles.begin(), draft.triangles.end());
    EXPECT_EQ(draft.triangles, triangles) << "none lost";
}

/// Border and candidates of a chunk from all posts.
Tin triangulated(const BuildGround& ground, const ChunkKey& key, const LatticeWindow& window) {
    const PostRange posts = ground.plan.lattice.posts_of(key);
    const auto post = [&](std::uint32_t i, std::uint32_t j) {
        const std::size_t n = window.at(i, j);
        return TinPost{static_cast<std::uint16_t>(i - posts.i0), static_cast<std::uint16_t>(j - posts.j0), window.surface_m[n],
                       window.post_class[n]};
    };
    std::vector<TinPost> border, candidates;
    for (const BorderPost& p : chunk_border(ground.plan, ground.lines, key)) border.push_back(post(p.i, p.j));
    for (std::uint32_t j = posts.j0 + 1; j < posts.j1; ++j)
        for (std::uint32_t i = posts.i0 + 1; i < posts.i1; ++i) candidates.push_back(post(i, j));
    return triangulate_chunk(ground.plan, ground.slopes, key, border, candidates, &window);
}

TEST(ChunkBuilder, MeshesAreWithinTheToleranceOfTheirLevel) {
    const BuildGround ground(test_support::make_raster(
        300, 200, [](auto i, auto j) { return static_cast<float>(300 * std::sin(i * 0.05) * std::cos(j * 0.07)); }));
    const LatticeWindow window = ground.all();
    std::size_t before = 1u << 20;
    for (const std::uint32_t level : {1u, 2u}) {
        const Tin tin = triangulated(ground, {level, 1, 0}, window);
        EXPECT_LE(tin.candidate_error_m, ground.plan.tolerance_m(level, 0));
        EXPECT_LT(tin.triangles.size() >> (2 * level), before) << "fewer a post";
        before = tin.triangles.size() >> (2 * level);
    }
}

TEST(ChunkBuilder, WhatDoesNotFitIsSpreadOverTheChunk) {
    std::mt19937 random(3);
    const BuildGround ground(
        test_support::make_raster(300, 300, [&](auto, auto) { return static_cast<float>(random() % 3000); }));
    const LatticeWindow window = ground.all();
    const Tin tin = triangulated(ground, {3, 0, 0}, window);
    EXPECT_LE(tin.vertices.size(), kMaxChunkVertices);
    int quarters[4] = {};
    for (const TinPost& v : tin.vertices) ++quarters[(v.i > 128 ? 1 : 0) + (v.j > 128 ? 2 : 0)];
    const auto [fewest, most] = std::minmax_element(quarters, quarters + 4);
    EXPECT_GT(2 * *fewest, *most);
}

TEST(ChunkBuilder, PayloadsAreVerticesThenIndices) {
    const BuildGround ground(test_support::make_rough_raster(80, 70));
    ChunkDraft draft = regular(ground, 0, 0);
    draft.triangles = {1, 2, 3};
    draft.entry.payload.bytes = static_cast<std::uint32_t>(draft.vertices.size() * sizeof(ChunkVertex) + 6);
    draft.entry.flags = 0;
    draft.entry.triangle_count = 1;
    const std::vector<std::uint8_t> bytes = payload_of(draft, 0);
    ASSERT_EQ(bytes.size(), draft.entry.payload.bytes);
    EXPECT_EQ(payload_vertices(draft.entry, {bytes.data(), bytes.size()})[40].i, draft.vertices[40].i);
    EXPECT_EQ(payload_indices(draft.entry, {bytes.data(), bytes.size()})[2], 3);
    const std::vector<std::uint8_t> lifted = payload_of(draft, 3);
    EXPECT_EQ(payload_vertices(draft.entry, {lifted.data(), lifted.size()})[40].j, draft.vertices[40].j * 8);
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_builder
