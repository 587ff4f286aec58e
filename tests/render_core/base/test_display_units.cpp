#include "render_core/base/display_units.hpp"

#include <gtest/gtest.h>

namespace tedavis::base::test_display_units {
namespace {

constexpr DisplayUnits kFeet = DisplayUnits::feet_and_knots, kMetric = DisplayUnits::metric;

TEST(DisplayUnits, WriteWhatTheirDefinitionsSay) {
    EXPECT_NEAR(height_unit(kFeet).of(914.4), 3000, 1e-9);
    EXPECT_NEAR(speed_unit(kFeet).of(1852.0 / 36), 100, 1e-9) << "a nautical mile in 36 s";
    EXPECT_NEAR(vertical_speed_unit(kFeet).of(2.54), 500, 1e-9);
    EXPECT_NEAR(distance_unit(kFeet).of(9260), 5, 1e-9);
    EXPECT_EQ(height_unit(kMetric).of(914.4), 914.4);
    EXPECT_NEAR(speed_unit(kMetric).of(50), 180, 1e-9);
    EXPECT_EQ(vertical_speed_unit(kMetric).of(2.5), 2.5);
    EXPECT_EQ(distance_unit(kMetric).of(9260), 9.26);
}

TEST(DisplayUnits, NoTwoHaveTheSameText) {
    const DisplayUnit all[] = {height_unit(kFeet),   speed_unit(kFeet),   vertical_speed_unit(kFeet),   distance_unit(kFeet),
                               height_unit(kMetric), speed_unit(kMetric), vertical_speed_unit(kMetric), distance_unit(kMetric)};
    for (const DisplayUnit& a : all)
        for (const DisplayUnit& b : all) EXPECT_EQ(a.text == b.text, &a == &b) << a.text;
}

}  // namespace
}  // namespace tedavis::base::test_display_units
