#include "render_core/terrain/block_extents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_block_extents {
namespace {

using test_support::TdbSpec;
using test_support::WrittenTdb;

constexpr std::uint32_t kSide = BlockExtents::kSide, kCells = BlockExtents::kCells;

/// Its exact chunks have 32 x 32 cells, and at the east and south borders 21 columns and rows of them.
TdbSpec hills() {
    TdbSpec spec;
    spec.columns = spec.rows = 150;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 1500 + 300 * std::sin(i * 0.09) * std::cos(j * 0.07); };
    return spec;
}

/// A chunk with the boxes of its blocks as a view sees them.
struct SeenChunk {
    SeenChunk(const WrittenTdb& tdb, const ChunkKey& key) : entry(tdb.entry(key)), vertices(tdb.vertices(key)) {
        const PostRange posts = tdb.lattice().posts_of(key);
        grid = regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, key.level);
        extents = block_extents(entry, grid, {vertices.data(), vertices.size()});
    }
    [[nodiscard]] glm::dvec3 place(std::uint32_t a, std::uint32_t b, const View& view) const {
        const ChunkVertex& v = vertices[grid.index_of(a, b)];
        const glm::dvec3 centre(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]);
        return seen(view, centre + glm::dvec3(double{v.x}, double{v.y}, double{v.z}) - view.eye);
    }
    /// The least box of a block's posts, by looking at all of them.
    [[nodiscard]] ViewBox box_of_posts(std::uint32_t block, const View& view) const {
        ViewBox box;
        const std::uint32_t a0 = block % kSide * kCells, b0 = block / kSide * kCells;
        if (a0 >= grid.columns - 1 || b0 >= grid.rows - 1) return box;
        for (std::uint32_t b = b0; b <= std::min(b0 + kCells, grid.rows - 1); ++b)
            for (std::uint32_t a = a0; a <= std::min(a0 + kCells, grid.columns - 1); ++a) box.include(place(a, b, view));
        return box;
    }

    ChunkEntry entry;
    std::vector<ChunkVertex> vertices;
    RegularGrid grid;
    BlockExtents extents;
};

bool holds(const ViewBox& outer, const ViewBox& inner, double less_m = 0) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(outer.low[axis] + less_m <= inner.low[axis] && inner.high[axis] <= outer.high[axis] - less_m)) return false;
    return true;
}

View view_along(const glm::dvec3& forward, const glm::dvec3& right, const glm::dvec3& eye) {
    View view;
    view.eye = eye;
    view.forward = glm::normalize(forward);
    view.right = glm::normalize(right - view.forward * glm::dot(right, view.forward));
    view.down = glm::cross(view.forward, view.right);
    return view;
}

View any_view(const ChunkEntry& entry, std::mt19937& random) {
    std::normal_distribution<double> normal;
    const auto direction = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
    const glm::dvec3 centre(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]);
    return view_along(direction(), direction(), centre + direction() * 3000.0);
}

TEST(BlockExtents, HoldEveryPostInAnyView) {
    const WrittenTdb tdb(hills());
    std::mt19937 random(7);
    int looked = 0, empty = 0;
    for (const ChunkKey& key : tdb.keys()) {
        if (key.level != 0) continue;
        const SeenChunk chunk(tdb, key);
        for (int n = 0; n < 20; ++n) {
            const View view = any_view(chunk.entry, random);
            for (std::uint32_t block = 0; block < kSide * kSide; ++block) {
                const ViewBox box = seen_block(chunk.entry, chunk.extents.blocks[block], view);
                const ViewBox posts = chunk.box_of_posts(block, view);
                EXPECT_EQ(box.is_empty(), posts.is_empty()) << block;
                if (posts.is_empty()) ++empty;
                if (posts.is_empty()) continue;
                EXPECT_TRUE(holds(box, posts)) << block;
                ++looked;
            }
        }
    }
    EXPECT_GT(looked, 1000);
    EXPECT_GT(empty, 100) << "chunks at the border have fewer blocks";
}

/// Where the view looks along the chunk's axes the boxes are those of the posts, so that a hand's breadth less loses some.
TEST(BlockExtents, AreNoLargerThanTheirPostsAlongTheChunksAxes) {
    const WrittenTdb tdb(hills());
    const SeenChunk chunk(tdb, {0, 0, 0});
    const auto axis = [&](int n) {
        return glm::dvec3(chunk.entry.axes[3 * n], chunk.entry.axes[3 * n + 1], chunk.entry.axes[3 * n + 2]);
    };
    const glm::dvec3 centre(chunk.entry.centre_m[0], chunk.entry.centre_m[1], chunk.entry.centre_m[2]);
    const View view = view_along(axis(0), axis(1), centre);
    for (std::uint32_t block = 0; block < kSide * kSide; ++block) {
        const ViewBox box = seen_block(chunk.entry, chunk.extents.blocks[block], view);
        EXPECT_TRUE(holds(box, chunk.box_of_posts(block, view))) << block;
        EXPECT_FALSE(holds(box, chunk.box_of_posts(block, view), 0.1)) << block;
        for (int n = 0; n < 3; ++n)
            EXPECT_NEAR(box.high[n] - box.low[n],
                        chunk.box_of_posts(block, view).high[n] - chunk.box_of_posts(block, view).low[n], 0.1);
    }
}

}  // namespace
}  // namespace tedavis::terrain::test_block_extents
