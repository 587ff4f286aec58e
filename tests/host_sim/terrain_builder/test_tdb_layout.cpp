#include "host_sim/terrain_builder/tdb_layout.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "render_core/terrain/regular_chunk.hpp"
#include "tests/host_sim/terrain_builder/post_grid.hpp"

namespace tedavis::host_sim::test_tdb_layout {
namespace {

using namespace terrain;

BuildPlan plan_of(std::uint32_t columns, std::uint32_t rows) {
    return make_build_plan(test_support::post_grid(0, 40, 0.001, columns, rows), {});
}

TEST(TdbLayout, PartsFollowEachOtherWithoutGapsAndOverlaps) {
    for (const auto& [columns, rows] : {std::pair{300u, 200u}, {33u, 33u}, {2u, 2u}, {65u, 34u}, {100u, 1000u}}) {
        const BuildPlan plan = plan_of(columns, rows);
        const TdbLayout layout(plan, plan.lattice, InsetCoverage());
        const Lattice& lattice = plan.lattice;
        std::map<std::uint64_t, std::uint64_t> parts;  // offset and bytes
        parts[0] = sizeof(FileHeader);
        parts[layout.page_table] = std::uint64_t{lattice.page_count()} * 8;
        parts[layout.pages] = std::uint64_t{lattice.page_count()} * sizeof(DirectoryPage);
        for (std::uint32_t j = 0; j < lattice.grid_rows(0); ++j)
            for (std::uint32_t i = 0; i < lattice.grid_columns(0); ++i) {
                const PartPlace place = layout.regular_place(i, j);
                const PostRange posts = lattice.posts_of({0, i, j});
                EXPECT_EQ(place.bytes,
                          regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, 0).vertex_count() * sizeof(ChunkVertex));
                parts[place.offset] = place.bytes;
            }
        for (std::uint32_t level = 1; level < plan.levels(); ++level)
            for (std::uint32_t j = 0; j < lattice.grid_rows(level); ++j)
                for (std::uint32_t i = 0; i < lattice.grid_columns(level); ++i)
                    parts[layout.attribute_place({level, i, j}).offset] = sizeof(AttributePage);
        const std::uint64_t grid_bytes = plan.undulation.undulation_m.size() * sizeof(float);
        parts[layout.undulation] = (grid_bytes + 7) / 8 * 8;
        std::uint64_t end = 0;
        for (const auto& [offset, bytes] : parts) {
            EXPECT_EQ(offset, end);
            end = offset + bytes;
        }
        EXPECT_EQ(end, layout.open_parts);
        EXPECT_EQ(layout.regular % 8, 0u);
    }
}

TEST(ChunkOrder, NamesEveryChunkOnce) {
    const BuildPlan plan = plan_of(300, 200);
    const ChunkOrder order(plan.lattice);
    std::set<std::uint64_t> seen;
    for (std::uint32_t level = 0; level < plan.levels(); ++level)
        for (std::uint32_t j = 0; j < plan.lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < plan.lattice.grid_columns(level); ++i) seen.insert(order.index({level, i, j}));
    EXPECT_EQ(seen.size(), order.count());
    EXPECT_EQ(*seen.rbegin(), order.count() - 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_tdb_layout
