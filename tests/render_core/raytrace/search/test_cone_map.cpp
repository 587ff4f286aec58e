#include "render_core/raytrace/search/cone_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_cone_map {
namespace {

using test_support::Dice;
using test_support::HeldHeights;
using test_support::SurfaceScene;

struct BuiltCones {
    std::vector<unsigned char> memory;
    base::Arena arena;
    ConeMap<std::int16_t> map;
    BuiltCones(const HeightGrid<std::int16_t>& grid, const ConeSettings& settings)
        : memory(ConeMap<std::int16_t>::bytes_needed(grid.columns, grid.rows)), arena(memory.data(), memory.size()) {
        EXPECT_TRUE(map.start(grid, settings, arena));
        base::SerialWorkers alone;
        map.build(alone);
    }
};

TEST(ConeMap, ConesAreWideOverFlatsAndHilltopsAndNarrowBesideWalls) {
    HeldHeights<std::int16_t> heights(65, 65, 0);
    for (std::uint32_t row = 0; row < 65; ++row) heights.at(32, row) = 50;
    const BuiltCones built(heights.grid(), {16, 16});
    EXPECT_GE(built.map.ratio(5, 30), 1e5f);
    EXPECT_GE(built.map.ratio(32, 30), 1e5f) << "nothing is higher";
    EXPECT_LT(built.map.ratio(26, 30), 1);
    EXPECT_LT(built.map.ratio(30, 30), built.map.ratio(26, 30));
}

TEST(ConeMap, HitsAreOnTheSurfaceAndMostlyTheFirst) {
    const SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(129, 129, 4, 60), SurfaceKind::bilinear);
    const BuiltCones built(scene.heights.grid(), {16, 24});
    Dice dice(1);
    int hits = 0, wrong = 0;
    for (int n = 0; n < 4000; ++n) {
        Ray ray;
        ray.origin = {dice.between(0, 128), dice.between(0, 128), 60};
        ray.direction = glm::vec3(glm::dvec3(dice.between(0, 128), dice.between(0, 128), 0) - ray.origin);
        const SurfaceHit exact = scene.trace(ray);
        SurfacePoint ground;
        if (!find_surface(scene.heights.grid(), scene.settings, ray.origin.x, ray.origin.y, ground) || ground.height > 60)
            continue;
        const SurfaceHit found = built.map.search(ray, {200, 24});
        EXPECT_TRUE(found.side == HitSide::none || std::abs(ray.origin.z + found.t * ray.direction.z - found.height) < 0.03);
        hits += exact.side != HitSide::none ? 1 : 0;
        const double posts = std::hypot(ray.direction.x, ray.direction.y);
        wrong += exact.side != found.side || (exact.side != HitSide::none && std::abs(exact.t - found.t) * posts > 1) ? 1 : 0;
    }
    EXPECT_GT(hits, 2000);
    EXPECT_LT(wrong, 4000 * 0.02);
}

TEST(ConeMap, RelaxedConesAreNeverNarrower) {
    const auto heights = test_support::hilly_heights<std::int16_t>(65, 65, 4, 60);
    const BuiltCones relaxed(heights.grid(), {16, 16, true}), narrow(heights.grid(), {16, 16, false});
    int wider = 0;
    for (std::uint32_t row = 0; row < 65; ++row)
        for (std::uint32_t column = 0; column < 65; ++column) {
            EXPECT_GE(relaxed.map.ratio(column, row), narrow.map.ratio(column, row) * 0.999f);
            wider += relaxed.map.ratio(column, row) > 1.5f * narrow.map.ratio(column, row) ? 1 : 0;
        }
    EXPECT_GT(wider, 65 * 65 / 4);
}

TEST(ConeMap, FewStepsLoseRaysNearTheHorizon) {
    const SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(129, 129, 4, 60), SurfaceKind::bilinear);
    const BuiltCones built(scene.heights.grid(), {16, 24});
    int few = 0, many = 0;
    Dice dice(2);
    for (int n = 0; n < 1500; ++n) {
        const Ray ray{{0, dice.between(0, 128), 20}, {1, 0, static_cast<float>(dice.between(-0.1, -0.02))}};
        if (scene.trace(ray).side == HitSide::none) continue;
        few += built.map.search(ray, {8, 16}).side == HitSide::none ? 1 : 0;
        many += built.map.search(ray, {500, 16}).side == HitSide::none ? 1 : 0;
    }
    EXPECT_GT(few, many);
    EXPECT_GT(few, 50);
}

}  // namespace
}  // namespace tedavis::raytrace::test_cone_map
