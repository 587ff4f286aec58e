#include "render_core/draw/drawers/scene_blur.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render_core/draw/drawers/view_effects_pass.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_scene_blur {
namespace {

using test_support::GlSession;

constexpr int kWidth = 96, kHeight = 64;

struct Pixel {
    std::array<double, 3> color;  ///< 0 to 255
    double code;                  ///< of its distance, 0 to 255
};
using Picture = std::vector<Pixel>;  ///< bottom row first

const Pixel& pixel_at(const Picture& picture, int x, int y) {
    const int column = std::clamp(x, 0, kWidth - 1), row = std::clamp(y, 0, kHeight - 1);
    return picture[static_cast<std::size_t>(row) * kWidth + static_cast<std::size_t>(column)];
}

/// Ground that recedes towards a ridge, sky, a near mast, and a warning, all with a pattern.
Picture scene() {
    Picture picture;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int ridge = 40 + static_cast<int>(6 * std::sin(x * 0.2));
            const bool is_mast = x >= 60 && x < 66, is_warning = x >= 20 && x < 26 && y >= 10 && y < 20;
            const double distance_m = is_mast ? 300 : 2000 * std::exp(0.06 * y);
            const double code = is_warning ? 0 : y > ridge && !is_mast ? 255 : std::round(255 * distance_code(distance_m));
            const double shade = 60 + 20 * ((x / 5 + y / 3) % 5) + (is_mast ? 80 : 0);
            picture.push_back({{shade, y > ridge ? 220.0 : shade * 0.8, is_warning ? 250.0 : 90.0}, code});
        }
    return picture;
}

const FocusRange kFocus{true, 3000, 6000, 6, 16};

/// Pixels, negative nearer than the focus: the circle of confusion, in double precision.
double radius_of(double code) {
    if (code < 0.5) return 0;
    if (code > 254.5) return kFocus.blur_px;
    const double distance_m = std::max(50 * (std::exp2(13 * code / 255) - 1), 1.0);
    const double far = std::max(1 - kFocus.far_m / distance_m, 0.0);
    const double near = std::clamp(kFocus.near_m / distance_m - 1, 0.0, 1.0);
    return kFocus.blur_px * (far - near);
}

/// The blur of every pixel by its definition: the mean of the places of a disc, each as far as it is blurred itself.
std::array<double, 3> expected_at(const Picture& picture, int x, int y) {
    const Pixel& here = pixel_at(picture, x, y);
    if (here.code < 0.5) return here.color;
    const double own = radius_of(here.code), golden = std::acos(-0.73736888);
    std::array<double, 3> sum = here.color;
    double weights = 1;
    for (std::uint32_t n = 0; n < kFocus.taps; ++n) {
        const double radius = std::sqrt((n + 0.5) / kFocus.taps) * kFocus.blur_px, angle = golden * n;
        const Pixel& tap = pixel_at(picture, x + static_cast<int>(std::floor(std::cos(angle) * radius + 0.5)),
                                    y + static_cast<int>(std::floor(std::sin(angle) * radius + 0.5)));
        const double other = std::fabs(radius_of(tap.code));
        const double reach = radius_of(tap.code) > own ? std::min(other, std::fabs(own)) : other;
        const double weight = std::clamp(reach - radius + 0.5, 0.0, 1.0);
        for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * tap.color[k];
        weights += weight;
    }
    for (double& channel : sum) channel /= weights;
    return sum;
}

Picture expected(const Picture& picture) {
    Picture blurred;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) blurred.push_back({expected_at(picture, x, y), pixel_at(picture, x, y).code});
    return blurred;
}

std::vector<std::uint8_t> texels_of(const Picture& picture) {
    std::vector<std::uint8_t> texels;
    for (const Pixel& pixel : picture) {
        for (const double channel : pixel.color) texels.push_back(static_cast<std::uint8_t>(std::lround(channel)));
        texels.push_back(static_cast<std::uint8_t>(std::lround(pixel.code)));
    }
    return texels;
}

/// As ViewEffectsPass shows it, with squares of so many pixels a side.
Picture drawn(const Picture& picture, std::uint32_t square_px, const FocusRange& focus = kFocus) {
    GlSession session("egl", "es3-mid", kWidth, kHeight);
    ViewEffectsPass pass;
    EXPECT_EQ(pass.start(session.gl, session.device.budget, kWidth, kHeight, {false, true, false, square_px}).message.view(), "");
    base::BudgetLine line;
    line.bytes = 100'000;
    auto texture = gl::make_texture(session.gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWidth, kHeight});
    test_support::ScreenTriangle triangle(session.gl);
    EXPECT_TRUE(texture.value().upload(session.gl, {0, 0, kWidth, kHeight}, texels_of(picture).data()));
    session.gl.begin_frame();
    pass.target().bind(session.gl);
    triangle.copy(session.gl, texture.value());
    ViewEffectsInput input;
    input.blurs = true;
    input.focus = focus;
    pass.finish(session.gl, *session.surface, input);
    const std::vector<std::uint8_t> rgba = session.pixels();
    EXPECT_EQ(session.gl.denied().total, 0u);
    texture.value().destroy(session.gl);
    triangle.destroy(session.gl);
    pass.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
    Picture shown;
    for (std::size_t n = 0; n < rgba.size(); n += 4)
        shown.push_back({{double(rgba[n]), double(rgba[n + 1]), double(rgba[n + 2])}, 0});
    return shown;
}

double mean_difference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(a[n].color[k] - b[n].color[k]);
    return sum / static_cast<double>(3 * a.size());
}

TEST(SceneBlur, SquaresOfOnePixelAreTheBlurByItsDefinition) {
    const Picture picture = scene(), blurred = expected(picture), shown = drawn(picture, 1);
    const double blur = mean_difference(picture, blurred), off = mean_difference(shown, blurred);
    EXPECT_GT(blur, 5) << "the scene is blurred at all";
    EXPECT_LT(off, 0.5) << "colours, radii and shares are rounded to 1/255 on the way";
}

TEST(SceneBlur, LargerSquaresAreNearIt) {
    const Picture picture = scene(), blurred = expected(picture);
    const double blur = mean_difference(picture, blurred);
    double former = 0;
    struct Square {
        std::uint32_t px;
        double share;  ///< of the blur's own change
    };
    for (const auto [square_px, share] : {Square{2, 0.35}, Square{4, 0.6}}) {
        const double off = mean_difference(drawn(picture, square_px), blurred);
        EXPECT_LT(off, share * blur) << square_px;
        EXPECT_GT(off, former) << square_px;
        former = off;
    }
}

TEST(SceneBlur, WarningsAreUntouchedAndDoNotSpread) {
    const Picture picture = scene();
    for (const std::uint32_t square_px : {1u, 2u, 3u}) {
        const Picture shown = drawn(picture, square_px);
        for (int y = 8; y < 22; ++y)
            for (int x = 18; x < 28; ++x) {
                const Pixel& was = pixel_at(picture, x, y);
                const Pixel& is = pixel_at(shown, x, y);
                if (was.code < 0.5)
                    EXPECT_EQ(is.color, was.color) << x << ' ' << y;
                else
                    EXPECT_LT(is.color[2], 100) << "blue of the warning at " << x << ' ' << y << ", squares of " << square_px;
            }
    }
}

TEST(SceneBlur, APictureInFocusIsItself) {
    Picture picture = scene();
    for (Pixel& pixel : picture) pixel.code = 255 * distance_code(4000);
    for (const std::uint32_t square_px : {1u, 2u, 3u, 4u}) EXPECT_EQ(mean_difference(drawn(picture, square_px), picture), 0);
}

TEST(SceneBlur, ASceneBeyondItsBudgetIsRefused) {
    GlSession session("egl", "es3-mid", kWidth, kHeight);
    session.device.budget.find(effects::kRenderTargets)->bytes = kWidth * kHeight * 4;
    SceneBlur blur;
    EXPECT_NE(blur.start(session.gl, session.device.budget, kWidth, kHeight, 1).message.view(), "");
    blur.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
}

TEST(SceneBlur, TheShaderIsToldTheEdgeOfASquare) { EXPECT_EQ(square_definition(3).view(), "#define TEXEL 3\n"); }

}  // namespace
}  // namespace tedavis::draw::test_scene_blur
