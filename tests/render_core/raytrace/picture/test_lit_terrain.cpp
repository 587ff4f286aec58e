#include "render_core/raytrace/picture/lit_terrain.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/picture/trace_presets.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

/// A plane of height 0, with a wall 100 high along one column.
test_support::HeightField<std::int16_t> walled_plane() {
    test_support::HeightField<std::int16_t> posts(65, 65);
    for (std::uint32_t row = 0; row < 65; ++row) posts.at(40, row) = 100;
    return posts;
}

TEST(LitTerrain, PathsSeeTheGroundTheWallAndTheSky) {
    test_support::DrawnTrace drawn(walled_plane(), {time_preset()}, 16, 16);
    drawn.look.ground.palette = {};
    drawn.look.material.color = {0.5f, 0.5f, 0.5f};
    drawn.look.material.gloss = 0;
    drawn.look.sun.towards = {0, 0, 1};
    const GridScale scale = {10, 20, 0.5};
    const LitTerrain lit = {&drawn.scene.terrain(drawn.settings[0]), &drawn.look, scale};
    const LitScene scene = lit.scene();
    const LitPlace ground = scene.intersect(scene.context, {205, 400, 300}, {0, 0, -1});
    ASSERT_TRUE(ground.is_hit);
    EXPECT_NEAR(ground.point.x, 205, 1e-3);
    EXPECT_NEAR(ground.point.y, 400, 1e-3);
    EXPECT_NEAR(ground.point.z, 0, 1e-3);
    EXPECT_GE(ground.point.z, 0);
    EXPECT_NEAR(ground.normal.z, 1, 1e-12);
    const LitPlace wall = scene.intersect(scene.context, ground.point + glm::dvec3(0, 0, 1), {1, 0, 0});
    ASSERT_TRUE(wall.is_hit);
    EXPECT_LT(wall.normal.x, -0.9);
    EXPECT_FALSE(scene.intersect(scene.context, ground.point, {0.1, 0, 1}).is_hit);
    EXPECT_TRUE(scene.is_hidden(scene.context, ground.point, {1, 0, 0.1}));
    EXPECT_FALSE(scene.is_hidden(scene.context, ground.point, {-1, 0, 0.1}));
    // A level plane far from the wall: the sun alone, and a bounce that sees an even sky, of which it keeps its colour.
    const glm::vec3 seen = traced_light(scene, {50, 400, 300}, {0, 0, -1}, {1, 64}, 1);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], 0.5f * drawn.look.sun.radiance[c] + 0.5f * drawn.look.sky[c], 0.03f);
}

TEST(LitTerrain, OnlyWhatIsLowMirrors) {
    test_support::DrawnTrace drawn(walled_plane(), {time_preset()}, 16, 16);
    drawn.look.material.mirror = 0.7f;
    drawn.look.mirror_below = 50;
    const LitTerrain lit = {&drawn.scene.terrain(drawn.settings[0]), &drawn.look, {10, 20, 0.5}};
    const LitScene scene = lit.scene();
    EXPECT_EQ(scene.intersect(scene.context, {205, 400, 300}, {0, 0, -1}).material.mirror, 0.7f);
    EXPECT_EQ(scene.intersect(scene.context, {399.9, 400, 300}, {0, 0, -1}).material.mirror, 0.0f);
}

}  // namespace
}  // namespace tedavis::raytrace
