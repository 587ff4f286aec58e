#include "render_core/scene/data_time.hpp"

#include <gtest/gtest.h>

#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::scene::test_data_time {
namespace {

TEST(DataTime, StepsAreWholeMinutesBeforeZeroAsWell) {
    EXPECT_EQ(start_of_data_step(0), 0);
    EXPECT_EQ(start_of_data_step(kDataStep_ns - 1), 0);
    EXPECT_EQ(start_of_data_step(kDataStep_ns), kDataStep_ns);
    EXPECT_EQ(start_of_data_step(-1), -kDataStep_ns);
    EXPECT_EQ(start_of_data_step(-kDataStep_ns), -kDataStep_ns);
}

TEST(DataTime, ALayersOwnTimeIsItsFirst) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.times_ns = {500, 900};
    EXPECT_EQ(own_time_ns(test_support::LoadedScene(layer).layer()), 500);
    host_sim::LayerDraft points = test_support::small_points();
    EXPECT_EQ(own_time_ns(test_support::LoadedScene(points).layer()), 0) << "nobody states one";
    points.data_time_ns = 77;
    EXPECT_EQ(own_time_ns(test_support::LoadedScene(points).layer()), 77);
}

}  // namespace
}  // namespace tedavis::scene::test_data_time
