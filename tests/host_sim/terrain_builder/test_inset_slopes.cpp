#include "host_sim/terrain_builder/inset_slopes.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_inset_slopes {
namespace {

using namespace terrain;

TEST(InsetSlopes, AreTheSteepestOfFineAndCoarsePosts) {
    test_support::BuildGround ground(test_support::make_raster(100, 80, [](auto i, auto) { return i == 98 ? 3000.0f : 0.0f; }));
    const BuildPlan fine = make_finer_plan(ground.plan, 2);
    const test_support::TemporaryFolder folder;
    InsetPosts posts(ground.posts, 2, {128, 128, 256, 256}, folder.file("p"));
    LatticeWindow window;
    window.i0 = window.j0 = 128;
    window.columns = window.rows = 129;
    window.height_m.assign(129 * 129, 0.0f);
    window.post_class.assign(129 * 129, PostClass::land);
    window.height_m[window.at(200, 200)] = 500;
    posts.write(window);
    InsetSlopes slopes(fine, ground.slopes, 2, posts, folder.file("s"));
    slopes.measure({2, 1, 1});
    const double spike = slopes.steepest({192, 192, 224, 224}, 0);
    EXPECT_GT(spike, 500 / 25.0);
    EXPECT_LT(spike, 500 / 10.0);
    EXPECT_LT(slopes.steepest({128, 128, 160, 160}, 0), 0.01);
    EXPECT_EQ(slopes.steepest({128, 128, 160, 160}, 60), spike) << "within the margin";
    EXPECT_GT(slopes.steepest({386, 10, 396, 40}, 0), 20) << "the coarse wall";
    EXPECT_EQ(InsetSlopes(fine, ground.slopes, 2, posts, folder.file("s")).steepest({192, 192, 224, 224}, 0), spike)
        << "from its file";
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_slopes
