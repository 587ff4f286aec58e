#include "host_sim/window/painted_rects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::host_sim::test_painted_rects {
namespace {

constexpr std::uint32_t kWidth = 61, kHeight = 37;

RgbaPicture plain() {
    RgbaPicture picture{kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight * 4, 51)};
    for (std::size_t n = 3; n < picture.pixels.size(); n += 4) picture.pixels[n] = 255;
    return picture;
}

/// Boxes and single pixels of a few colors, some of them that of the picture below.
RgbaPicture painted(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto below = [&random](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    RgbaPicture picture = plain();
    for (int box = 0; box < 40; ++box) {
        const std::uint32_t left = below(kWidth), top = below(kHeight);
        const std::uint32_t right = std::min(kWidth, left + 1 + below(9)), bottom = std::min(kHeight, top + 1 + below(9));
        const auto shade = static_cast<std::uint8_t>(51 * below(4));
        for (std::uint32_t y = top; y < bottom; ++y)
            for (std::uint32_t x = left; x < right; ++x) picture.pixels[(std::size_t{y} * kWidth + x) * 4 + 1] = shade;
    }
    return picture;
}

TEST(PaintedRects, TurnOnePictureIntoTheOther) {
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        const RgbaPicture before = plain(), after = painted(seed);
        RgbaPicture copy = before;
        std::vector<int> times(std::size_t{kWidth} * kHeight, 0);
        for (const PaintedRect& rect : changed_rects(view_of(before), view_of(after)))
            for (std::uint32_t y = rect.top; y < rect.top + rect.height; ++y)
                for (std::uint32_t x = rect.left; x < rect.left + rect.width; ++x) {
                    const std::size_t n = std::size_t{y} * kWidth + x;
                    ++times[n];
                    std::copy(rect.color.begin(), rect.color.end(), &copy.pixels[n * 4]);
                }
        EXPECT_EQ(copy.pixels, after.pixels) << seed;
        for (std::size_t n = 0; n < times.size(); ++n)
            ASSERT_EQ(times[n], before.pixels[n * 4 + 1] == after.pixels[n * 4 + 1] ? 0 : 1) << seed;
    }
}

TEST(PaintedRects, ABoxIsOne) {
    const RgbaPicture before = plain();
    RgbaPicture after = before;
    for (std::uint32_t y = 5; y < 30; ++y)
        for (std::uint32_t x = 7; x < 50; ++x) after.pixels[(std::size_t{y} * kWidth + x) * 4] = 9;
    const std::vector<PaintedRect> rects = changed_rects(view_of(before), view_of(after));
    ASSERT_EQ(rects.size(), 1u);
    EXPECT_EQ(rects[0].width * rects[0].height, 43u * 25u);
    EXPECT_TRUE(changed_rects(view_of(before), view_of(before)).empty()) << "control";
}

TEST(PaintedRects, ArePaintedToTheBitOnEveryDevice) {
    for (const char* device : {"es2-small", "es3-mid", "sc2"}) {
        test_support::GlSession at("egl", device, kWidth, kHeight);
        at.gl->ClearColor(0.2f, 0.2f, 0.2f, 1);
        at.gl->Clear(GL_COLOR_BUFFER_BIT);
        const RgbaPicture before = plain(), after = painted(3);
        const auto drawn = [&] {
            const std::vector<std::uint8_t> pixels = at.pixels();
            return upright({pixels.data(), kWidth, kHeight, true});
        };
        ASSERT_EQ(drawn().pixels, before.pixels);
        paint_rects(at.gl, kHeight, changed_rects(view_of(before), view_of(after)));
        EXPECT_EQ(drawn().pixels, after.pixels) << device;
        at.gl->ClearColor(0.2f, 0.2f, 0.2f, 1);
        at.gl->Clear(GL_COLOR_BUFFER_BIT);
        EXPECT_EQ(drawn().pixels, before.pixels) << "nothing keeps the next frame from all of the surface";
        EXPECT_EQ(at.gl.denied().total, 0u);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_painted_rects
