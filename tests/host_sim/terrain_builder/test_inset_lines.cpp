#include "host_sim/terrain_builder/inset_lines.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_inset_lines {
namespace {

using namespace terrain;
using test_support::BuildGround;

/// Rough coarse posts, eight fine ones to each, an inset in the middle whose posts are the coarse surface's.
struct Lines {
    static constexpr std::uint32_t kLevels = 3;
    BuildGround ground{test_support::make_rough_raster(150, 110)};
    BuildPlan fine = make_finer_plan(ground.plan, kLevels);
    InsetCoverage coverage{fine.lattice, kLevels, {{480, 400, 640, 500}}};
    test_support::TemporaryFolder folder;
    InsetPosts posts{ground.posts, kLevels, coverage.regions()[0], folder.file("p")};
    InsetLines lines{fine, coverage, ground.lines, posts, folder.file("l")};

    Lines() {
        const PostRange& region = posts.region();
        LatticeWindow window;
        window.i0 = region.i0;
        window.j0 = region.j0;
        window.columns = region.i1 - region.i0 + 1;
        window.rows = region.j1 - region.j0 + 1;
        interpolate_posts(ground.posts, kLevels, window);
        for (std::uint32_t j = 410; j < 490; ++j)
            for (std::uint32_t i = 490; i < 630; ++i)
                window.height_m[window.at(i, j)] += static_cast<float>((i * 7 + j * 5) % 11);
        posts.write(window);
        const RegionBlocks blocks(region, kLevels);
        for (std::uint32_t n = 0; n < blocks.count(); ++n) lines.build(blocks.chunk(n));
    }
};

TEST(InsetLines, CoarseBordersAreThoseOfTheCoarsePosts) {
    const Lines made;
    const PostRange& region = made.posts.region();
    for (std::uint32_t j = region.j0; j <= region.j1; j += 256) {
        const std::uint32_t count = (region.i1 - region.i0) / 8 + 1;
        const std::vector<std::uint8_t> fine = made.lines.along(LineDirection::row, j, region.i0, region.i1 - region.i0 + 1),
                                        coarse = made.ground.lines.along(LineDirection::row, j / 8, region.i0 / 8, count);
        for (std::uint32_t n = 0; n < count; ++n) ASSERT_EQ(fine[8 * n], coarse[n] + 3);
        for (std::uint32_t n = 0; n < fine.size(); ++n)
            ASSERT_TRUE(n % 8 == 0 || fine[n] < 3) << "no fine post on a coarse border";
    }
}

TEST(InsetLines, BesideAnExactChunkStandsEveryPostThatItHas) {
    const Lines made;
    int exact = 0;
    for (std::uint32_t level = 1; level < 3; ++level)
        for (std::uint32_t j = 0; j < made.fine.lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < made.fine.lattice.grid_columns(level); ++i) {
                if (!made.coverage.is_exact({level, i, j})) continue;
                ++exact;
                const PostRange posts = made.fine.lattice.posts_of({level, i, j});
                for (const std::vector<std::uint8_t>& side :
                     {made.lines.along(LineDirection::row, posts.j0, posts.i0, posts.i1 - posts.i0 + 1),
                      made.lines.along(LineDirection::row, posts.j1, posts.i0, posts.i1 - posts.i0 + 1),
                      made.lines.along(LineDirection::column, posts.i0, posts.j0, posts.j1 - posts.j0 + 1),
                      made.lines.along(LineDirection::column, posts.i1, posts.j0, posts.j1 - posts.j0 + 1)})
                    for (std::uint32_t n = 0; n < side.size(); ++n)
                        ASSERT_EQ(side[n] >= level, n % (1u << level) == 0) << level << " " << i << " " << j << " " << n;
            }
    EXPECT_GT(exact, 10);
}

TEST(InsetLines, RoughPostsStayAtFineLevels) {
    const Lines made;
    int first = 0;
    for (const std::uint8_t level : made.lines.along(LineDirection::row, 448, 490, 140)) first += level == 1 ? 1 : 0;
    EXPECT_GT(first, 40) << "row 448 is a border of level 1";
    for (const std::uint8_t level : made.lines.along(LineDirection::row, 480, 490, 100))
        EXPECT_EQ(level, 0) << "and row 480 of level 0 only";
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_lines
