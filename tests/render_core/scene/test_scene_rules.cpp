#include "render_core/scene/scene_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "render_core/base/units.hpp"

namespace tedavis::scene::test_scene_rules {
namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();
const float kInfinity = std::numeric_limits<float>::infinity();

TEST(SceneRules, PointsLieOnTheEarth) {
    const auto holds = [](double latitude_rad, double longitude_rad, float height_m) {
        const ScenePoint point{latitude_rad, longitude_rad, height_m, 0, kNoTime};
        return points_hold({&point, 1});
    };
    EXPECT_TRUE(holds(0.5 * base::kPi, -base::kPi, 0));
    EXPECT_TRUE(holds(0, 0, kNan)) << "on the ground";
    EXPECT_FALSE(holds(1.58, 0, 0));
    EXPECT_FALSE(holds(0, 3.15, 0));
    EXPECT_FALSE(holds(std::nan(""), 0, 0));
    EXPECT_FALSE(holds(0, std::nan(""), 0));
    EXPECT_FALSE(holds(0, 0, kInfinity));
    EXPECT_TRUE(points_hold({}));
}

TEST(SceneRules, RunsFollowEachOther) {
    using Starts = std::vector<std::uint32_t>;
    const auto holds = [](const Starts& starts, std::uint32_t points, std::uint32_t least) {
        return starts_hold({starts.data(), starts.size()}, points, least);
    };
    EXPECT_TRUE(holds({0, 3, 7}, 7, 3));
    EXPECT_TRUE(holds({0}, 0, 3)) << "no feature";
    EXPECT_FALSE(holds({}, 0, 1));
    EXPECT_FALSE(holds({1, 3}, 3, 1));
    EXPECT_FALSE(holds({0, 3, 2, 7}, 7, 1));
    EXPECT_FALSE(holds({0, 3, 6}, 7, 1));
    EXPECT_FALSE(holds({0, 3, 5}, 5, 3));
}

TEST(SceneRules, LevelsAndTimesAscend) {
    const auto levels = [](std::vector<float> m) { return levels_hold({m.data(), m.size()}); };
    const auto times = [](std::vector<std::int64_t> ns) { return times_hold({ns.data(), ns.size()}); };
    EXPECT_TRUE(levels({0, 500, 5000}));
    EXPECT_FALSE(levels({0, 500, 500}));
    EXPECT_FALSE(levels({0, kNan, 5000}));
    EXPECT_FALSE(levels({kNan}));
    EXPECT_FALSE(levels({0, kInfinity}));
    EXPECT_TRUE(times({-5, 0, 9}));
    EXPECT_FALSE(times({0, 0}));
    EXPECT_FALSE(times({9, 0}));
}

TEST(SceneRules, ValuesLieWithinTheirLimitsOrAreMissing) {
    AttributeEntry entry{};
    entry.scale = AttributeScale::quantitative;
    entry.minimum = -2;
    entry.maximum = 5;
    const auto holds = [&entry](std::vector<float> values) { return values_hold({values.data(), values.size()}, entry); };
    EXPECT_TRUE(holds({-2, 5, kNan, 0.3F}));
    EXPECT_FALSE(holds({5.1F}));
    EXPECT_FALSE(holds({kInfinity}));
    entry.scale = AttributeScale::ordinal;
    entry.minimum = 0;
    entry.class_count = 4;
    EXPECT_TRUE(holds({0, 3, kNan}));
    EXPECT_FALSE(holds({4}));
    EXPECT_FALSE(holds({1.5F}));
    EXPECT_FALSE(holds({-1}));
}

TEST(SceneRules, ModelsStandOnTheirVertices) {
    const std::vector<ModelVertex> vertices(3, ModelVertex{{1, 2, 3}, {0, 0, 127, 0}, {}});
    std::vector<std::uint16_t> triangle{0, 1, 2};
    EXPECT_TRUE(model_holds({vertices.data(), 3}, {triangle.data(), 3}));
    triangle[1] = 3;
    EXPECT_FALSE(model_holds({vertices.data(), 3}, {triangle.data(), 3}));
    std::vector<ModelVertex> far = vertices;
    far[2].place_m[0] = 20000;
    EXPECT_FALSE(model_holds({far.data(), 3}, {}));
    far[2].place_m[0] = kNan;
    EXPECT_FALSE(model_holds({far.data(), 3}, {}));
}

TEST(SceneRules, GridsGoRoundTheEarthOnce) {
    LayerEntry entry{};
    entry.name[0] = 'g';
    entry.shape = LayerShape::grid;
    entry.grid = {-base::kPi, 0.5 * base::kPi, base::radians(1), base::radians(1), 361, 181, 1, 1};
    entry.feature_count = entry.point_count = 361 * 181;
    EXPECT_TRUE(entry_holds(entry, 0));
    entry.grid.columns = 363;
    entry.feature_count = entry.point_count = 363 * 181;
    EXPECT_FALSE(entry_holds(entry, 0));
    entry.grid.columns = 361;
    entry.grid.rows = 183;
    entry.feature_count = entry.point_count = 361 * 183;
    EXPECT_FALSE(entry_holds(entry, 0)) << "beyond the south pole";
}

TEST(SceneRules, AreasHaveThreePoints) {
    EXPECT_EQ(least_points(LayerShape::areas), 3u);
    EXPECT_EQ(least_points(LayerShape::lines), 1u);
}

}  // namespace
}  // namespace tedavis::scene::test_scene_rules
