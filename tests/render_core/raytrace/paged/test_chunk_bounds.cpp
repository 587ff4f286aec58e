#include "render_core/raytrace/paged/chunk_bounds.hpp"

#include <gtest/gtest.h>

#include "tests/support/raytrace/held_chunks.hpp"

namespace tedavis::raytrace::test_chunk_bounds {
namespace {

using Bounds = ChunkBounds<std::int16_t>;

struct StartedBounds {
    StartedBounds(std::uint32_t columns, std::uint32_t rows, bool has_holes)
        : hills(columns, rows, has_holes), field(hills.field(CellSurface::two_triangles)), chunks(field.grid()) {}
    Bounds::Started start() {
        memory.resize(Bounds::bytes_needed(chunks.columns(), chunks.rows()) / 8 + 1);
        base::Arena arena(memory.data(), memory.size() * 8);
        return bounds.start(chunks, arena);
    }
    test_support::ViewedHills<std::int16_t> hills;
    TracedField<std::int16_t> field;
    test_support::HeldChunks<std::int16_t> chunks;
    std::vector<std::uint64_t> memory;
    Bounds bounds;
};

TEST(ChunkBounds, AreTheMipmapsOwnFromTheFifthLevelUp) {
    for (const auto& [columns, rows] : {std::pair{271u, 190u}, {33u, 33u}, {2u, 2u}, {65u, 34u}, {1025u, 40u}}) {
        StartedBounds ground(columns, rows, false);
        ASSERT_EQ(ground.start(), Bounds::Started::yes);
        const MipmapLayout& layout = ground.bounds.layout();
        const MipmapLayout& whole = ground.field.maxima->layout();
        EXPECT_EQ(layout.top, std::max(whole.top, kChunkLevel));
        for (int level = kChunkLevel; level <= whole.top; ++level)
            for (std::int32_t n = 0; n < layout.columns[level] * layout.rows[level]; ++n) {
                const auto node = static_cast<std::uint32_t>(n);
                ASSERT_EQ(ground.bounds.maxima()[layout.first[level] + n],
                          ground.field.maxima->level(static_cast<std::uint32_t>(level)).nodes[node]);
                ASSERT_EQ(ground.bounds.minima()[layout.first[level] + n],
                          ground.field.minima->level(static_cast<std::uint32_t>(level)).nodes[node]);
            }
    }
}

TEST(ChunkBounds, AChunkWithoutHeightsBoundsNothing) {
    test_support::ViewedHills<std::int16_t> hills(40, 40, false);
    std::vector<std::int16_t> posts(100 * 40, HeightGrid<std::int16_t>::kVoid);
    for (std::uint32_t n = 0; n < 40; ++n) posts[n * 100 + 5] = 7;
    test_support::HeldChunks<std::int16_t> chunks({posts.data(), 100, 40, 100});
    std::vector<std::uint64_t> memory(Bounds::bytes_needed(100, 40) / 8 + 1);
    base::Arena arena(memory.data(), memory.size() * 8);
    Bounds bounds;
    ASSERT_EQ(bounds.start(chunks, arena), Bounds::Started::yes);
    EXPECT_EQ(bounds.highest(0), 7);
    EXPECT_EQ(bounds.highest(1), no_surface<std::int16_t>(HeightBound::maximum));
    EXPECT_EQ(bounds.lowest(1), no_surface<std::int16_t>(HeightBound::minimum));
}

TEST(ChunkBounds, SaysWhyItCannotStart) {
    StartedBounds ground(100, 100, false);
    ground.chunks.is_unreadable = true;
    EXPECT_EQ(ground.start(), Bounds::Started::unreadable);
    base::Arena arena(ground.memory.data(), 10);
    EXPECT_EQ(ground.bounds.start(ground.chunks, arena), Bounds::Started::no_room);
}

}  // namespace
}  // namespace tedavis::raytrace::test_chunk_bounds
