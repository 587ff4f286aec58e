#include "render_core/draw/drawers/view_effects_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_view_effects_pass {
namespace {

using test_support::GlSession;

constexpr std::uint32_t kWidth = 64, kHeight = 48;

struct Texel {
    std::uint8_t grey;
    double distance_m;
};
using Scene = std::function<Texel(int, int)>;  ///< columns from the left, rows from the bottom

/// Red of every pixel after the pass, bottom row first; or of the scene itself without effects.
std::vector<int> seen(const Scene& scene, const ViewEffectsInput& input) {
    GlSession session("egl", "es3-mid", kWidth, kHeight);
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < static_cast<int>(kHeight); ++y)
        for (int x = 0; x < static_cast<int>(kWidth); ++x) {
            const Texel texel = scene(x, y);
            const auto code = static_cast<std::uint8_t>(std::lround(255 * distance_code(texel.distance_m)));
            texels.insert(texels.end(), {texel.grey, texel.grey, texel.grey, code});
        }
    ViewEffectsPass pass;
    EXPECT_EQ(
        pass.start(session.gl, session.device.budget, kWidth, kHeight, {true, input.focus.blur_px > 0, false}).message.view(),
        "");
    base::BudgetLine line;
    line.bytes = 100'000;
    auto picture = gl::make_texture(session.gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight});
    test_support::ScreenTriangle triangle(session.gl);
    EXPECT_TRUE(picture.value().upload(session.gl, {0, 0, kWidth, kHeight}, texels.data()));
    session.gl.begin_frame();
    pass.target().bind(session.gl);
    triangle.copy(session.gl, picture.value());
    pass.finish(session.gl, *session.surface, input);
    const auto rgba = session.pixels();
    EXPECT_EQ(session.gl.denied().total, 0u);
    std::vector<int> reds;
    for (std::size_t n = 0; n < rgba.size(); n += 4) reds.push_back(rgba[n]);
    picture.value().destroy(session.gl);
    triangle.destroy(session.gl);
    pass.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
    return reds;
}

ViewEffectsInput blur(double near_m, double far_m, double px = 6) {
    ViewEffectsInput input;
    input.blurs = true;
    input.focus = {true, near_m, far_m, px};
    return input;
}

ViewEffectsInput smooth() {
    ViewEffectsInput input;
    input.smooths = true;
    return input;
}

std::uint8_t stripes(int x) { return x / 4 % 2 == 0 ? 200 : 40; }

int contrast(const std::vector<int>& picture, int row = 24) {
    int least = 255, most = 0;
    for (int x = 16; x < 48; ++x) {
        const int red = picture[static_cast<std::size_t>(row) * kWidth + static_cast<std::size_t>(x)];
        least = std::min(least, red);
        most = std::max(most, red);
    }
    return most - least;
}

TEST(ViewEffectsPass, OnePictureOfOneColorStaysAsItIs) {
    const Scene scene = [](int x, int) { return Texel{123, 100.0 + 400.0 * x}; };
    ViewEffectsInput both = blur(3000, 4000);
    both.smooths = true;
    for (const ViewEffectsInput& input : {blur(3000, 4000), smooth(), both})
        for (const int red : seen(scene, input)) ASSERT_EQ(red, 123);
}

TEST(ViewEffectsPass, WhatIsInFocusIsSharpAndTheRestIsBlurred) {
    const auto at = [](double distance_m) { return [distance_m](int x, int) { return Texel{stripes(x), distance_m}; }; };
    EXPECT_EQ(contrast(seen(at(3000), blur(2000, 5000))), 160) << "every pixel as it was";
    EXPECT_LT(contrast(seen(at(60'000), blur(2000, 5000))), 60);
    EXPECT_LT(contrast(seen(at(700), blur(2000, 5000))), 60);
    EXPECT_GT(contrast(seen(at(5600), blur(2000, 5000))), 120) << "hardly out of focus";
}

/// Far stripes behind a near pane that is in focus: the pane's edge stays where it is, and nothing of it glows.
TEST(ViewEffectsPass, TheEdgeOfWhatIsInFocusDoesNotGlow) {
    const Scene scene = [](int x, int) { return x < 32 ? Texel{250, 1000} : Texel{50, 100'000}; };
    const std::vector<int> picture = seen(scene, blur(500, 2000));
    for (int x = 0; x < 32; ++x) EXPECT_EQ(picture[24 * kWidth + static_cast<std::size_t>(x)], 250) << x;
    for (int x = 32; x < 64; ++x) EXPECT_LE(picture[24 * kWidth + static_cast<std::size_t>(x)], 60) << x;
}

/// What is nearer than the focus spreads over what is in focus behind it.
TEST(ViewEffectsPass, ABlurredForegroundHasSoftEdges) {
    const Scene scene = [](int x, int) { return x < 32 ? Texel{250, 100} : Texel{50, 3000}; };
    const std::vector<int> picture = seen(scene, blur(2000, 5000));
    EXPECT_GT(picture[24 * kWidth + 33], 80);
    EXPECT_EQ(picture[24 * kWidth + 50], 50);
}

double roughness(const std::vector<int>& picture) {
    double sum = 0;
    for (std::size_t y = 4; y < kHeight - 4; ++y)
        for (std::size_t x = 4; x < kWidth - 5; ++x) {
            const double step = std::abs(picture[y * kWidth + x + 1] - picture[y * kWidth + x]);
            sum += step * step;
        }
    return sum;
}

TEST(ViewEffectsPass, SmoothsTheStairsOfAnEdgeAndNothingElse) {
    const Scene edge = [](int x, int y) { return Texel{static_cast<std::uint8_t>(y * 8 < x * 3 + 100 ? 220 : 30), 1000}; };
    const std::vector<int> picture = seen(edge, smooth());
    int changed = 0;
    for (int y = 0; y < static_cast<int>(kHeight); ++y)
        for (int x = 0; x < static_cast<int>(kWidth); ++x) {
            const int red = picture[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
            if (red == edge(x, y).grey) continue;
            ++changed;
            EXPECT_LE(std::fabs(y - (x * 3 + 100) / 8.0), 2.5) << "far from the edge";
            EXPECT_GE(red, 30);
            EXPECT_LE(red, 220);
        }
    EXPECT_GT(changed, 60) << "most of 64 columns";
    std::vector<int> hard;
    for (int y = 0; y < static_cast<int>(kHeight); ++y)
        for (int x = 0; x < static_cast<int>(kWidth); ++x) hard.push_back(edge(x, y).grey);
    EXPECT_LT(roughness(picture), roughness(hard));
}

TEST(ViewEffectsPass, AnUprightEdgeStaysSharp) {
    const Scene upright = [](int x, int) { return Texel{static_cast<std::uint8_t>(x < 30 ? 220 : 30), 1000}; };
    const std::vector<int> picture = seen(upright, smooth());
    for (int x = 0; x < static_cast<int>(kWidth); ++x)
        EXPECT_EQ(picture[24 * kWidth + static_cast<std::size_t>(x)], x < 30 ? 220 : 30) << x;
}

TEST(ViewEffectsPass, CodesAreThoseOfTheTerrain) {
    EXPECT_EQ(distance_code(0), 0);
    EXPECT_NEAR(distance_code(50), 1 / kDistanceCodeOctaves, 1e-12);
    EXPECT_EQ(distance_code(1e9), 254.0 / 255) << "255 is infinitely far";
    EXPECT_FALSE(DistanceLeft{}.is_left());
    EXPECT_TRUE((DistanceLeft{0, 1}).is_left());
}

}  // namespace
}  // namespace tedavis::draw::test_view_effects_pass
