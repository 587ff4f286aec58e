#include "render_core/display/planner/stated_layer.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace tedavis::display::test_stated_layer {
namespace {

TEST(StatedLayer, IsValidAtAnyTimeAndFromOnBoard) {
    scene::LayerEntry entry{};
    name_layer(entry, "own_trail", "Own");
    EXPECT_STREQ(entry.name, "own_trail");
    EXPECT_STREQ(entry.title, "Own");
    EXPECT_STREQ(entry.source, "on board");
    EXPECT_LT(entry.valid_from_ns, 0);
    EXPECT_EQ(entry.valid_until_ns, INT64_MAX);
    EXPECT_EQ(entry.data_time_ns, scene::kNoTime);
    scene::AttributeEntry attribute{};
    name_attribute(attribute, "height_accuracy", "m");
    EXPECT_STREQ(attribute.name, "height_accuracy");
    EXPECT_STREQ(attribute.unit, "m");
    EXPECT_EQ(attribute.of, scene::AttributeOf::point);
}

TEST(StatedLayer, TheRangeIsThatOfWhatIsThere) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    scene::AttributeEntry attribute{};
    const std::vector<float> values = {kNaN, -3, kNaN, 7, 2}, nothing = {kNaN};
    set_range({values.data(), values.size()}, attribute);
    EXPECT_EQ(attribute.minimum, -3);
    EXPECT_EQ(attribute.maximum, 7);
    EXPECT_EQ(attribute.value_count, 5u);
    set_range({nothing.data(), 1}, attribute);
    EXPECT_EQ(attribute.minimum, 0);
    EXPECT_EQ(attribute.maximum, 0);
}

}  // namespace
}  // namespace tedavis::display::test_stated_layer
