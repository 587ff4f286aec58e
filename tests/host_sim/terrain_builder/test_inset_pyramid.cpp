#include "host_sim/terrain_builder/inset_pyramid.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"
#include "tests/support/terrain/lattice_windows.hpp"

namespace tedavis::host_sim::test_inset_pyramid {
namespace {

using namespace terrain;
using test_support::window_of;

/// Coarse posts on a plane of 8 m to the east a post; the fine ones of the region, four to each, on one of 2 m.
struct Built {
    test_support::BuildGround ground{test_support::make_raster(100, 80, [](auto i, auto) { return 8.0f * i; })};
    BuildPlan fine = make_finer_plan(ground.plan, 2);
    test_support::TemporaryFolder folder;
    HeightPyramid coarse{folder.path(), ground.posts, false};
    InsetPosts posts{ground.posts, 2, {128, 128, 256, 256}, folder.file("p")};
    RegionPyramid region{posts, ground.posts, 2, folder.file("r")};
    InsetPyramid pyramid{coarse, 2, fine.lattice};

    Built() {
        for (std::uint32_t m = 1; m < coarse.level_count(); ++m)
            for (std::uint32_t b = 0; b < coarse.block_count(m); ++b) coarse.build_block(m, b);
        LatticeWindow window = window_of(128, 128, 129, 129);
        for (std::int64_t j = 128; j <= 256; ++j)
            for (std::int64_t i = 128; i <= 256; ++i) {
                window.height_m.push_back(2.0f * static_cast<float>(i) + 100);  // 100 m above the coarse plane
                window.post_class.push_back(PostClass::land);
            }
        posts.write(window);
        for (std::uint32_t b = 0; b < region.block_count(1); ++b) region.build_block(1, b);
        pyramid.add(region);
    }
};

TEST(InsetPyramid, HasTheSizesOfTheDatabase) {
    const Built built;
    EXPECT_EQ(built.pyramid.level_count(), built.coarse.level_count() + 2);
    EXPECT_EQ(built.pyramid.columns(0), built.fine.header.columns);
    EXPECT_EQ(built.pyramid.columns(1), 199u);
    EXPECT_EQ(built.pyramid.rows(2), 80u);
    EXPECT_EQ(built.pyramid.columns(3), built.coarse.columns(1));
}

TEST(InsetPyramid, FineLevelsAreTheRegionsOwn) {
    const Built built;
    for (std::uint32_t level = 0; level < 2; ++level) {
        LatticeWindow window = window_of(140 >> level, 140 >> level, 40, 40);
        built.pyramid.read(level, window);
        for (std::int64_t j = window.j0; j < window.j0 + 40; ++j)
            for (std::int64_t i = window.i0; i < window.i0 + 40; ++i)
                ASSERT_NEAR(window.height_m[window.at(i, j)], 2.0f * static_cast<float>(i << level) + 100, 1e-3) << level;
    }
}

TEST(InsetPyramid, ElsewhereTheyAreInterpolatedAndCoarseLevelsAreTheTerrains) {
    const Built built;
    for (std::uint32_t level = 0; level < 4; ++level) {
        LatticeWindow window = window_of(300 >> level, 40 >> level, 5, 5);
        built.pyramid.read(level, window);
        for (std::int64_t i = window.i0; i < window.i0 + 5; ++i)
            ASSERT_NEAR(window.height_m[window.at(i, window.j0 + 2)], 2.0f * static_cast<float>(i << level), 1e-3) << level;
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_pyramid
