#include "host_sim/accuracy/knobs/scaled_picture.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_scaled_picture {
namespace {

/// Red grows by columns, green by rows.
RgbaPicture slopes(std::uint32_t width, std::uint32_t height, int step) {
    RgbaPicture picture{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (const std::uint32_t value :
                 {x * static_cast<std::uint32_t>(step), y * static_cast<std::uint32_t>(step), 7u, 255u})
                picture.pixels.push_back(static_cast<std::uint8_t>(value));
    return picture;
}

TEST(ScaledPicture, IsLinearBetweenTheMiddlesOfPixels) {
    const RgbaPicture small = slopes(4, 3, 40), large = scaled_picture(view_of(small), {8, 6});
    ASSERT_EQ(large.pixels.size(), 4u * 8 * 6);
    const auto red = [&](int x) { return int{large.pixels[4 * static_cast<std::size_t>(x)]}; };
    EXPECT_EQ(red(0), 0) << "beyond the first middle";
    EXPECT_EQ(red(1), 10) << "a quarter on the way to the second";
    EXPECT_EQ(red(2), 30);
    EXPECT_EQ(red(7), 120) << "beyond the last middle";
    EXPECT_EQ(large.pixels[4 * 8 * 2 + 1], 30) << "rows likewise";
    EXPECT_EQ(large.pixels[2], 7) << "what is even stays";
}

TEST(ScaledPicture, OfItsOwnSizeIsThePictureTopRowFirst) {
    const RgbaPicture picture = slopes(5, 4, 30);
    EXPECT_EQ(scaled_picture(view_of(picture), {5, 4}).pixels, picture.pixels);
    const RgbaView bottom_up{picture.pixels.data(), 5, 4, true};
    EXPECT_EQ(scaled_picture(bottom_up, {5, 4}).pixels, upright(bottom_up).pixels);
    EXPECT_NE(upright(bottom_up).pixels, picture.pixels) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_scaled_picture
