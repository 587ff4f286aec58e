#include "host_sim/terrain_builder/coarse_chunks.hpp"

#include <gtest/gtest.h>

#include <set>

#include "host_sim/terrain_builder/surface_heights.hpp"
#include "render_core/terrain/chunk_payload.hpp"
#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_coarse_chunks {
namespace {

using namespace terrain;
using test_support::BuildGround;

/// Smooth, so that tolerances above the units can be met.
Raster smooth_raster() {
    return test_support::make_raster(
        1500, 70, [](auto i, auto j) { return static_cast<float>(4000 * std::sin(i * 0.03) * std::cos(j * 0.06)); });
}

/// Mountains with spurs, whose ridges the sides of coarse triangles cross.
Raster rugged_raster() {
    return test_support::make_raster(1100, 90, [](auto i, auto j) {
        return static_cast<float>(2000 * std::sin(i * 0.02) * std::cos(j * 0.017) + 1500 * std::sin(i * 0.07 + j * 0.05) +
                                  900 * std::abs(std::sin(i * 0.11 - j * 0.13)));
    });
}

struct Coarse {
    BuildGround ground;
    ChunkKey key{kUnitLevel + 1, 0, 0};
    IrregularChunk chunk;

    explicit Coarse(const Raster& raster = smooth_raster()) : ground(raster) {
        ground.build_units();
        chunk = build_coarse_chunk(ground.sources, ground.entries, key);
        (void)ground.append(chunk, ground.end_of_units);
    }
};

TEST(CoarseChunks, TakeTheirVerticesFromTheMeshesBelowAndFromSpreadPosts) {
    Coarse coarse;
    const PostRange posts = coarse.ground.plan.lattice.posts_of(coarse.key);
    std::set<std::pair<std::uint32_t, std::uint32_t>> below;
    const std::uint32_t level = coarse.key.level - kLevelsBelow;
    for (std::uint32_t j = 0; j < coarse.ground.plan.lattice.grid_rows(level); ++j)
        for (std::uint32_t i = 0; i < coarse.ground.plan.lattice.grid_columns(level); ++i) {
            const ChunkEntry entry = coarse.ground.entries.read({level, i, j});
            std::vector<std::uint8_t> bytes(entry.payload.bytes);
            coarse.ground.store.get(entry.payload, bytes.data());
            const PostRange at = coarse.ground.plan.lattice.posts_of({level, i, j});
            for (const ChunkVertex& v : payload_vertices(entry, {bytes.data(), bytes.size()}))
                below.insert({at.i0 + v.i, at.j0 + v.j});
        }
    const base::Span<const ChunkVertex> vertices =
        payload_vertices(coarse.chunk.entry, {coarse.chunk.payload.data(), coarse.chunk.payload.size()});
    EXPECT_GT(vertices.size(), coarse.chunk.entry.border_count + 4u);
    std::uint32_t of_meshes = 0;
    for (std::uint32_t n = coarse.chunk.entry.border_count; n < vertices.size(); ++n) {
        const bool is_below = below.count({posts.i0 + vertices[n].i, posts.j0 + vertices[n].j}) != 0;
        EXPECT_TRUE(is_below || (vertices[n].i % 4 == 0 && vertices[n].j % 4 == 0)) << n;
        of_meshes += is_below ? 1 : 0;
    }
    EXPECT_GT(of_meshes, 0u);
    EXPECT_EQ(coarse.chunk.entry.children, 0b0011) << "one row of units";
}

/// Between the vertices of the meshes below as well, where sides of coarser triangles cross the edges of finer ones.
TEST(CoarseChunks, AreWithinTheToleranceAtSpreadPosts) {
    Coarse coarse(rugged_raster());
    const BuildPlan& plan = coarse.ground.plan;
    const PostRange posts = plan.lattice.posts_of(coarse.key);
    LatticeWindow window;
    window.columns = plan.header.columns;
    window.rows = plan.header.rows;
    coarse.ground.sources.posts.read(window);
    add_undulation(plan, window);
    const auto bytes = coarse.chunk.payload;
    const base::Span<const ChunkVertex> vertices = payload_vertices(coarse.chunk.entry, {bytes.data(), bytes.size()});
    const base::Span<const std::uint16_t> indices = payload_indices(coarse.chunk.entry, {bytes.data(), bytes.size()});
    const auto surface = [&](std::uint32_t i, std::uint32_t j) { return double{window.surface_m[window.at(i, j)]}; };
    const auto area = [](double ai, double aj, double bi, double bj) { return ai * bj - aj * bi; };
    const auto first_after = [](std::uint16_t post) { return std::max((post + 3u) / 4 * 4, 4u); };
    double worst_m = 0;
    int found = 0;
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        const ChunkVertex &a = vertices[indices[n]], &b = vertices[indices[n + 1]], &c = vertices[indices[n + 2]];
        const double whole = area(b.i - a.i, b.j - a.j, c.i - a.i, c.j - a.j);
        for (std::uint32_t j = first_after(std::min({a.j, b.j, c.j})); j <= std::max({a.j, b.j, c.j}) && j < posts.j1; j += 4)
            for (std::uint32_t i = first_after(std::min({a.i, b.i, c.i})); i <= std::max({a.i, b.i, c.i}) && i < posts.i1;
                 i += 4) {
                const double di = static_cast<double>(i) - a.i, dj = static_cast<double>(j) - a.j;
                const double wb = area(di, dj, c.i - a.i, c.j - a.j) / whole, wc = area(b.i - a.i, b.j - a.j, di, dj) / whole;
                if (wb < 0 || wc < 0 || wb + wc > 1) continue;
                const double drawn_m = (1 - wb - wc) * surface(a.i, a.j) + wb * surface(b.i, b.j) + wc * surface(c.i, c.j);
                worst_m = std::max(worst_m, std::abs(drawn_m - surface(i, j)));
                ++found;
            }
    }
    EXPECT_GT(found, 1000);
    EXPECT_LE(worst_m, plan.tolerance_m(coarse.key.level, 0) * (1 + 1e-6));
}

TEST(CoarseChunks, AreMeasuredByAllUnitsBelow) {
    Coarse coarse;
    ChunkErrors all;
    double first = 0;
    for (std::uint32_t unit = 0; unit < coarse.ground.plan.unit_count(); ++unit) {
        const std::vector<CoarseErrors> errors = measure_above(coarse.ground.sources, coarse.ground.entries, unit);
        ASSERT_EQ(errors.size(), coarse.ground.plan.levels() - kUnitLevel - 1);
        EXPECT_EQ(errors[0].chunk, coarse.key);
        all.include(errors[0].errors);
        if (unit == 0) first = errors[0].errors.own.largest_m();
    }
    EXPECT_GE(all.own.largest_m(), first);
    EXPECT_LT(all.own.largest_m(), 3 * coarse.ground.plan.tolerance_m(coarse.key.level, 0));
    EXPECT_GT(all.own.largest_m(), 0.1 * coarse.ground.plan.tolerance_m(coarse.key.level, 0));
}

}  // namespace
}  // namespace tedavis::host_sim::test_coarse_chunks
