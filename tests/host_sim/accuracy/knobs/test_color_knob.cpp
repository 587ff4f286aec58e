#include "host_sim/accuracy/knobs/color_knob.hpp"

#include <gtest/gtest.h>

#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim::test_color_knob {
namespace {

RgbaPicture grey(std::uint32_t width, std::uint32_t height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 100)};
}

TEST(ColorKnob, FindsTheOnePixelThatDiffers) {
    const RgbaPicture exact = grey(8, 6);
    RgbaPicture other = exact;
    other.pixels[4 * (8 * 4 + 5)] = 200;
    const double difference =
        color_difference(lab_of(design::linear_rgb({200, 100, 100})), lab_of(design::linear_rgb({100, 100, 100})));
    std::vector<double> pixels, tiles;
    append_color_differences(view_of(other), view_of(exact), {1, 1}, pixels);
    ASSERT_EQ(pixels.size(), 48u);
    for (std::size_t n = 0; n < 48; ++n) EXPECT_DOUBLE_EQ(pixels[n], n == 8 * 4 + 5 ? difference : 0) << n;
    append_color_differences(view_of(other), view_of(exact), {4, 2}, tiles);
    ASSERT_EQ(tiles.size(), 6u);
    for (std::size_t n = 0; n < 6; ++n) EXPECT_DOUBLE_EQ(tiles[n], n == 5 ? difference / 8 : 0) << n;
    EXPECT_GT(difference, 10) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_color_knob
