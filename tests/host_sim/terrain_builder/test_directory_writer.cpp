#include "host_sim/terrain_builder/directory_writer.hpp"

#include <gtest/gtest.h>

#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_directory_writer {
namespace {

using namespace terrain;
using test_support::BuiltDatabase;

/// From the format's words, by looking at every pair of chunks.
float expected_bound(const BuiltDatabase& built, const ChunkKey& key) {
    const ChunkEntry own = built.entry(key);
    const PostRange a = built.lattice().posts_of(key);
    float bound = std::max(own.above_m, own.below_m);
    if (key.level == 0) return bound;
    for (std::uint32_t j = 0; j < built.lattice().grid_rows(key.level - 1); ++j)
        for (std::uint32_t i = 0; i < built.lattice().grid_columns(key.level - 1); ++i) {
            const ChunkKey finer{key.level - 1, i, j};
            const ChunkEntry entry = built.entry(finer);
            if (finer.parent() == key) {
                bound = std::max(bound, entry.bound_m);
                continue;
            }
            const PostRange b = built.lattice().posts_of(finer);
            const bool rows_overlap = b.j0 < a.j1 && b.j1 > a.j0, columns_overlap = b.i0 < a.i1 && b.i1 > a.i0;
            const bool beside =
                (rows_overlap && (b.i0 == a.i1 || b.i1 == a.i0)) || (columns_overlap && (b.j0 == a.j1 || b.j1 == a.j0));
            if (beside) bound = std::max({bound, entry.strip_above_m, entry.strip_below_m});
        }
    return bound;
}

TEST(DirectoryWriter, BoundsHoldStripsOfFinerNeighboursAndChildren) {
    const Raster rough = test_support::make_rough_raster(300, 200);
    const Raster raster = test_support::make_raster(300, 200, [&](auto i, auto j) {  // flat beside rough
        return i < 130 ? 0.0f : 5 * rough.height_m[rough.at(i, j)];
    });
    const BuiltDatabase built(raster);
    int by_strips = 0;
    for (const ChunkKey& key : built.chunks()) {
        const ChunkEntry entry = built.entry(key);
        EXPECT_EQ(entry.bound_m, expected_bound(built, key)) << key.level << "/" << key.i << "/" << key.j;
        by_strips += entry.bound_m > std::max(entry.above_m, entry.below_m) ? 1 : 0;
        const bool top = key.level + 1 == built.lattice().levels();
        EXPECT_TRUE(top || entry.bound_m <= built.entry(key.parent()).bound_m);
    }
    EXPECT_GT(by_strips, 1);
}

TEST(DirectoryWriter, EveryChunkStandsInItsPage) {
    const Raster raster = test_support::make_rough_raster(700, 300);
    const BuiltDatabase built(raster);
    EXPECT_GT(built.lattice().page_columns(0), 2u);
    for (const ChunkKey& key : built.chunks()) {
        const ChunkEntry entry = built.entry(key);
        EXPECT_EQ(key_of(entry), key);
        EXPECT_NE(entry.vertex_count, 0);
    }
    EXPECT_EQ(built.database.header().chunk_count, built.chunks().size());
    EXPECT_EQ(built.database.header().file_bytes, built.image.size());
}

}  // namespace
}  // namespace tedavis::host_sim::test_directory_writer
