#include "render_core/design/color.hpp"

#include <gtest/gtest.h>

namespace tedavis::design::test_color {
namespace {

TEST(Color, ReadsSixAndEightDigitsOfEitherCase) {
    EXPECT_EQ(color_from_text("#12aBfF").color, (Color{0x12, 0xAB, 0xFF, 0xFF}));
    EXPECT_EQ(color_from_text("#00010203").color, (Color{0, 1, 2, 3}));
    EXPECT_TRUE(color_from_text("#ffffff").ok);
}

TEST(Color, RefusesEverythingElse) {
    for (const char* text : {"", "#", "123456", "#12345", "#1234567", "#12345g", "#+12345", "#12 456", "#123456789", " #123456"})
        EXPECT_FALSE(color_from_text(text).ok) << text;
}

TEST(Color, BlendKeepsEndsAndIsMonotonic) {
    const Color dark{10, 200, 0, 0}, light{250, 20, 0, 255};
    EXPECT_EQ(blended(dark, light, 0), dark);
    EXPECT_EQ(blended(dark, light, 1), light);
    EXPECT_EQ(blended(dark, light, -3), dark);
    EXPECT_EQ(blended(dark, light, 7), light);
    for (int i = 0; i < 100; ++i) {
        const Color a = blended(dark, light, i / 100.0), b = blended(dark, light, (i + 1) / 100.0);
        EXPECT_LE(a.red, b.red);
        EXPECT_GE(a.green, b.green);
    }
}

TEST(Color, LuminanceOfBlackWhiteAndMiddleGrey) {
    EXPECT_DOUBLE_EQ(relative_luminance({0, 0, 0}), 0.0);
    EXPECT_NEAR(relative_luminance({255, 255, 255}), 1.0, 1e-12);
    EXPECT_NEAR(linear_light(188), 0.5, 0.005);  // 188 is the usual encoding of half the light
}

}  // namespace
}  // namespace tedavis::design::test_color
