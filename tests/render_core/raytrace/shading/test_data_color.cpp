#include "render_core/raytrace/shading/data_color.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tedavis::raytrace::test_data_color {
namespace {

const glm::vec3 kPalette[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

struct TwoGrids {
    float values[12], doubts[12];
    DataGrid value{values, 4, 3, 10, 20, 2, -2}, doubt{doubts, 4, 3, 10, 20, 2, -2};
    DataLegend legend;
    TwoGrids() {
        for (int n = 0; n < 12; ++n) {
            values[n] = static_cast<float>(n % 4);
            doubts[n] = 0;
        }
        legend.palette = kPalette;
        legend.highest = 3;
    }
};

TEST(DataColor, ValuesPickClasses) {
    const TwoGrids made;
    EXPECT_EQ(data_color(made.value, made.doubt, made.legend, 10, 20).color, kPalette[0]);
    EXPECT_EQ(data_color(made.value, made.doubt, made.legend, 11.9, 18).color, kPalette[0]);
    EXPECT_EQ(data_color(made.value, made.doubt, made.legend, 12.1, 18).color, kPalette[1]);
    EXPECT_EQ(data_color(made.value, made.doubt, made.legend, 16, 16).color, kPalette[2]) << "the last post is inside";
    EXPECT_EQ(data_color(made.value, made.doubt, made.legend, 16, 16).cover, 1);
    for (const double outside : {9.99, 16.01}) EXPECT_EQ(data_color(made.value, made.doubt, made.legend, outside, 18).cover, 0);
}

TEST(DataColor, ClassesHaveEqualWidthAndEnds) {
    EXPECT_EQ(class_of(-1e30f, 0, 3, 3), 0u);
    EXPECT_EQ(class_of(0.999f, 0, 3, 3), 0u);
    EXPECT_EQ(class_of(1, 0, 3, 3), 1u);
    EXPECT_EQ(class_of(3, 0, 3, 3), 2u);
    EXPECT_EQ(class_of(1e30f, 0, 3, 3), 2u);
    EXPECT_EQ(class_of(std::numeric_limits<float>::infinity(), 0, 3, 3), 2u);
    EXPECT_EQ(class_of(5, 5, 5, 3), 0u) << "a legend without width has one class";
}

TEST(DataColor, DoubtMakesTransparent) {
    TwoGrids made;
    for (float& doubt : made.doubts) doubt = 0.25f;
    made.legend.cover = 0.8f;
    EXPECT_FLOAT_EQ(data_color(made.value, made.doubt, made.legend, 12, 18).cover, 0.6f);
    for (float& doubt : made.doubts) doubt = 7;
    EXPECT_EQ(data_color(made.value, made.doubt, made.legend, 12, 18).cover, 0);
}

TEST(DataColor, WhatIsUnknownCoversNothing) {
    for (int n = 0; n < 12; ++n)
        for (const bool is_value : {true, false}) {
            TwoGrids made;
            (is_value ? made.values : made.doubts)[n] = std::nanf("");
            const double x = 10 + 2 * (n % 4), y = 20 - 2 * (n / 4);
            EXPECT_EQ(data_color(made.value, made.doubt, made.legend, x, y).cover, 0);
            EXPECT_EQ(
                data_color(made.value, made.doubt, made.legend, x + (n % 4 == 3 ? -0.1 : 0.1), y + (n / 4 == 2 ? 0.1 : -0.1))
                    .cover,
                0);
        }
    EXPECT_EQ(data_color({}, {}, {}, 0, 0).cover, 0);
}

}  // namespace
}  // namespace tedavis::raytrace::test_data_color
