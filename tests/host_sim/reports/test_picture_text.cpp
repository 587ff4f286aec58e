#include "host_sim/reports/picture_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "render_core/draw/font_atlas.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"

namespace tedavis::host_sim::test_picture_text {
namespace {

constexpr std::uint32_t kWidth = 240, kHeight = 60;

RgbaPicture white() { return {kWidth, kHeight, std::vector<std::uint8_t>(kWidth * kHeight * 4, 255)}; }

/// Of the ink, in whole pixels that are darker than half.
struct Ink {
    std::uint32_t left = kWidth, right = 0, top = kHeight, bottom = 0, pixels = 0;

    explicit Ink(const RgbaPicture& picture) {
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                if (picture.pixels[(std::size_t{y} * kWidth + x) * 4] > 127) continue;
                left = std::min(left, x);
                right = std::max(right, x + 1);
                top = std::min(top, y);
                bottom = std::max(bottom, y + 1);
                ++pixels;
            }
    }
};

TEST(PictureText, StandsOnItsBaselineAsTallAsItsCapitals) {
    for (const float size : {12.0f, 20.0f, 33.0f}) {
        RgbaPicture picture = white();
        draw_text(picture, "HIT", 20, 45, {size, {}});
        const Ink ink(picture);
        const float cap_height = draw::font_atlas().cap_height_em * size;
        EXPECT_NEAR(ink.bottom, 45, 1);
        EXPECT_NEAR(static_cast<float>(ink.bottom - ink.top), cap_height, 1.5f) << size;
        EXPECT_GE(ink.left, 20u);
        EXPECT_LE(static_cast<float>(ink.right), 20 + draw::text_width_px("HIT", size));
        EXPECT_GT(static_cast<float>(ink.right - ink.left), 0.8f * draw::text_width_px("HIT", size) - 2);
    }
}

// The display's own way of drawing text, on another rasterizer.
TEST(PictureText, LooksAsTheDisplayDrawsIt) {
    const std::string text = "Ridges & valleys 1\xC2\xB0";
    RgbaPicture picture = white();
    draw_text(picture, text, 7.3f, 40.6f, {18, {20, 60, 140}});
    std::vector<draw::QuadVertex> vertices(400);
    std::vector<std::uint16_t> indices(600);
    draw::QuadBatch batch({vertices.data(), vertices.size()}, {indices.data(), indices.size()});
    const float centre_y = 40.6f - draw::font_atlas().cap_height_em * 18 / 2;  // a batch anchors text by its middle
    draw::TextStyle style;
    style.size_px = 18;
    style.color = {20, 60, 140};
    style.halo_px = 0;
    ASSERT_TRUE(batch.text(text, {7.3f, centre_y}, draw::TextAnchor::left, style));
    test_support::Picture expected(kWidth, kHeight, {255, 255, 255});
    test_support::rasterize(batch, expected);
    for (std::size_t n = 0; n < std::size_t{kWidth} * kHeight; ++n)
        for (std::size_t c = 0; c < 3; ++c)
            ASSERT_LE(std::abs(picture.pixels[n * 4 + c] - expected.rgb[n * 3 + c]), 2) << "pixel " << n;
    EXPECT_GT(Ink(picture).pixels, 200u);
}

TEST(PictureText, StaysInsideThePicture) {
    for (const auto& [x, y] : {std::pair{-30.0f, 20.0f}, {220.0f, 20.0f}, {10.0f, 5.0f}, {10.0f, 65.0f}, {-5000.0f, -5000.0f}}) {
        RgbaPicture picture = white();
        draw_text(picture, "Wide words", x, y, {20, {}});
        EXPECT_EQ(picture.pixels.size(), std::size_t{kWidth} * kHeight * 4);
    }
    RgbaPicture picture = white();
    draw_text(picture, "", 10, 20, {20, {}});
    EXPECT_EQ(Ink(picture).pixels, 0u);
}

TEST(PictureText, FitsWhereItIsTooWide) {
    const std::string text = "Colours relative to own altitude";
    const PictureTextStyle style{20, {1, 2, 3}};
    EXPECT_EQ(fitted(text, style, 1000).size_px, 20);
    const PictureTextStyle smaller = fitted(text, style, 100);
    EXPECT_NEAR(draw::text_width_px(text, smaller.size_px), 100, 0.01);
    EXPECT_EQ(smaller.color, style.color);
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_text
