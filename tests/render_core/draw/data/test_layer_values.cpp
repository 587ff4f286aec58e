#include "render_core/draw/data/layer_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/scene/grid_field.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::draw::test_layer_values {
namespace {

using test_support::LoadedScene;

constexpr std::int64_t kHour_ns = 3'600'000'000'000;

TEST(LayerValues, OfAGridAreThoseOfItsPostsAtTheTime) {
    const LoadedScene scene(test_support::small_grid());
    const scene::GridField field(scene.layer(), scene.attribute());
    for (const std::int64_t time_ns : {std::int64_t{-5}, std::int64_t{0}, kHour_ns / 4, kHour_ns, 2 * kHour_ns}) {
        const LayerValues values(scene.layer(), "temperature", time_ns);
        ASSERT_EQ(values.size(), 24u);
        for (std::size_t n = 0; n < 24; ++n) {
            const LayerValues::Place at = values.post(n);
            const double level_m = n < 12 ? 1000 : 3000;
            const scene::FieldValue expected = field.at(at.latitude_rad, at.longitude_rad, level_m, time_ns);
            if (expected.state == scene::ValueState::missing)
                EXPECT_TRUE(std::isnan(values[n])) << n;
            else
                EXPECT_NEAR(values[n], expected.value, 1e-3) << n;
        }
    }
}

TEST(LayerValues, WindHasASpeed) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.role = scene::LayerRole::wind;
    layer.attributes[0].name = "east";
    layer.attributes.push_back(layer.attributes[0]);
    layer.attributes[1].name = "north";
    const LoadedScene scene(layer);
    EXPECT_TRUE(LayerValues::has(scene.layer(), "speed"));
    EXPECT_FALSE(LayerValues::has(scene.layer(), "up"));
    const LayerValues east(scene.layer(), "east", 0), speed(scene.layer(), "speed", 0);
    ASSERT_EQ(speed.size(), east.size());
    for (std::size_t n = 0; n < east.size(); ++n)
        EXPECT_TRUE(std::isnan(east[n]) || std::fabs(speed[n] - std::sqrt(2) * std::fabs(east[n])) < 1e-4) << n;
    EXPECT_EQ(LayerValues(scene.layer(), "up", 0).size(), 0u);
}

TEST(LayerValues, OfFeaturesHaveThePointsOfEach) {
    const LoadedScene scene(test_support::small_areas());
    const LayerValues values(scene.layer(), "floor", 0);
    ASSERT_EQ(values.size(), 2u);
    EXPECT_EQ(values[1], 2000);
    EXPECT_EQ(values.points_of(1).first, 3u);
    EXPECT_EQ(values.points_of(1).count, 4u);
    EXPECT_FALSE(values.is_of_points());
}

}  // namespace
}  // namespace tedavis::draw::test_layer_values
