#include "host_sim/terrain_builder/coarse_chunks.hpp"

#include <gtest/gtest.h>

#include <set>

#include "render_core/terrain/chunk_payload.hpp"
#include "tests/support/build_ground.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;
using test_support::BuildGround;

/// Smooth, so that tolerances above the units can be met.
Raster smooth_raster() {
    return test_support::make_raster(
        1500, 70, [](auto i, auto j) { return static_cast<float>(4000 * std::sin(i * 0.03) * std::cos(j * 0.06)); });
}

struct Coarse {
    BuildGround ground{smooth_raster()};
    ChunkKey key{kUnitLevel + 1, 0, 0};
    IrregularChunk chunk;

    Coarse() {
        ground.build_units();
        chunk = build_coarse_chunk(ground.sources, ground.entries, key);
        (void)ground.append(chunk, ground.end_of_units);
    }
};

TEST(CoarseChunks, TakeTheirVerticesFromTheMeshesBelow) {
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
    for (std::uint32_t n = coarse.chunk.entry.border_count; n < vertices.size(); ++n)
        EXPECT_EQ(below.count({posts.i0 + vertices[n].i, posts.j0 + vertices[n].j}), 1u);
    EXPECT_EQ(coarse.chunk.entry.children, 0b0011) << "one row of units";
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
}  // namespace tedavis::host_sim
