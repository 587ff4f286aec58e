#include "host_sim/measure/picture_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/design/color_difference.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_picture_difference {
namespace {

constexpr std::uint32_t kWidth = 16, kHeight = 8;

struct Rgb {
    std::uint8_t red, green, blue;
};

template <class ColorAt>
RgbaPicture picture(ColorAt color_at) {
    RgbaPicture made{kWidth, kHeight, {}};
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const Rgb color = color_at(x, y);
            for (std::uint8_t byte : {color.red, color.green, color.blue, std::uint8_t{255}}) made.pixels.push_back(byte);
        }
    return made;
}

RgbaPicture flat(Rgb color) {
    return picture([&](std::uint32_t, std::uint32_t) { return color; });
}

TEST(PictureDifference, OfAPictureAndItselfIsNothing) {
    const RgbaPicture some = picture([](std::uint32_t x, std::uint32_t y) {
        return Rgb{static_cast<std::uint8_t>(x * 15), static_cast<std::uint8_t>(y * 30), 90};
    });
    const PictureDifference none = picture_difference(view_of(some), view_of(some));
    EXPECT_EQ(none.mean, 0);
    EXPECT_EQ(none.largest, 0);
    EXPECT_EQ(none.edges, 0);
}

TEST(PictureDifference, OfFlatTonesIsTheirColorDifferenceWithoutEdges) {
    const double expected =
        color_difference(lab_of(design::linear_rgb({200, 30, 30})), lab_of(design::linear_rgb({190, 40, 30})));
    const PictureDifference two = picture_difference(view_of(flat({200, 30, 30})), view_of(flat({190, 40, 30})));
    EXPECT_DOUBLE_EQ(two.largest, expected);
    EXPECT_NEAR(two.mean, expected, 1e-9);
    EXPECT_NEAR(two.edges, 0, 1e-12);
}

TEST(PictureDifference, OfOnePixelIsItsShareAndHasEdges) {
    const RgbaPicture dot = picture([](std::uint32_t x, std::uint32_t y) {
        return x == 5 && y == 3 ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
    });
    const PictureDifference one = picture_difference(view_of(dot), view_of(flat({0, 0, 0})));
    EXPECT_NEAR(one.largest, 100, 1e-6);
    EXPECT_NEAR(one.mean, 100.0 / (kWidth * kHeight), 1e-6);
    // Sobel round a point of lightness 100: four straight neighbours with 2/8 of it, four corners with sqrt(2)/8.
    EXPECT_NEAR(one.edges, 100 * (4 * 2 + 4 * std::sqrt(2.0)) / 8 / (kWidth * kHeight), 1e-6);
}

TEST(PictureDifference, DoesNotDependOnWhichRowComesFirstInMemory) {
    const RgbaPicture some = picture([](std::uint32_t x, std::uint32_t y) {
        return Rgb{static_cast<std::uint8_t>(x * y), static_cast<std::uint8_t>(y * 30), 90};
    });
    RgbaView turned = view_of(some);
    turned.bottom_up = true;
    const RgbaPicture copy = upright(turned);
    EXPECT_EQ(picture_difference(turned, view_of(copy)).largest, 0);
    EXPECT_GT(picture_difference(turned, view_of(some)).largest, 0);
}

TEST(PictureDifference, NeedsEqualSizes) {
    const RgbaPicture small{4, 4, std::vector<std::uint8_t>(64)};
    test_support::expect_user_error([&] { (void)picture_difference(view_of(small), view_of(flat({0, 0, 0}))); }, "sizes");
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_difference
