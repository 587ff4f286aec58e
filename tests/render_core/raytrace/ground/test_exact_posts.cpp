#include "render_core/raytrace/ground/exact_posts.hpp"

#include <gtest/gtest.h>

#include "tests/support/terrain/ground_files.hpp"

namespace tedavis::raytrace::test_exact_posts {
namespace {

using test_support::OpenedGround;

constexpr float kNoHeight = HeightGrid<float>::kVoid;

/// One chunk of level 2 with a void post at (8, 12), alone in a window that is larger than it.
struct CoarseChunk {
    CoarseChunk() : ground(spec()), heights(140 * 140, -7.0f) {
        const terrain::ExactChunk chunk = ground.query.exact_chunk(0, 0);
        EXPECT_EQ(chunk.entry->level, 2u);
        const GroundWindow<float> window{{0, 0, 139, 139}, heights, 1};
        put_exact_posts(ground.database.lattice(), *chunk.entry, chunk.vertices, window, rounding);
    }
    static test_support::TdbSpec spec() {
        test_support::TdbSpec spec = test_support::rough_file(257, 257);
        spec.is_exact = [](const terrain::ChunkKey& key) { return key.level == 2; };
        spec.post_class = [](std::uint32_t i, std::uint32_t j) {
            return i == 8 && j == 12 ? terrain::PostClass::void_ : terrain::PostClass::land;
        };
        return spec;
    }
    [[nodiscard]] float at(std::uint32_t i, std::uint32_t j) const { return heights[std::size_t{j} * 140 + i]; }

    OpenedGround ground;
    std::vector<float> heights;
    GroundRounding rounding;
};

TEST(ExactPosts, PostsBetweenLieOnItsTrianglesAndNothingElseIsWritten) {
    const CoarseChunk chunk;
    const auto height = CoarseChunk::spec().height_m;
    const auto stored = [&](std::uint32_t i, std::uint32_t j) { return double{static_cast<float>(height(i, j))}; };
    EXPECT_EQ(chunk.at(40, 44), static_cast<float>(stored(40, 44)));
    EXPECT_FLOAT_EQ(chunk.at(41, 44), 0.75 * stored(40, 44) + 0.25 * stored(44, 44));
    EXPECT_FLOAT_EQ(chunk.at(42, 46), 0.5 * stored(44, 44) + 0.5 * stored(40, 48)) << "the diagonal";
    EXPECT_FLOAT_EQ(chunk.at(41, 45), 0.5 * stored(40, 44) + 0.25 * stored(44, 44) + 0.25 * stored(40, 48));
    EXPECT_FLOAT_EQ(chunk.at(43, 47), 0.5 * stored(44, 48) + 0.25 * stored(44, 44) + 0.25 * stored(40, 48));
    EXPECT_NE(chunk.at(128, 128), -7);
    EXPECT_EQ(chunk.at(129, 50), -7) << "another chunk's";
    EXPECT_EQ(chunk.at(50, 129), -7);
}

TEST(ExactPosts, ACellWithAVoidCornerIsVoidAllOver) {
    const CoarseChunk chunk;
    for (std::uint32_t j = 0; j <= 24; ++j)
        for (std::uint32_t i = 0; i <= 20; ++i) {
            const bool is_within = i > 4 && i < 12 && j > 8 && j < 16;
            EXPECT_EQ(chunk.at(i, j) == kNoHeight, is_within) << i << ", " << j;
        }
}

}  // namespace
}  // namespace tedavis::raytrace::test_exact_posts
