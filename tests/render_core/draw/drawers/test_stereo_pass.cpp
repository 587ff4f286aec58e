#include "render_core/draw/drawers/stereo_pass.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "render_core/effects/device.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_stereo_pass {
namespace {

using design::StereoMode;

constexpr std::uint32_t kWidth = 64, kHeight = 16, kMargin = 5, kWide = kWidth + 2 * kMargin;

/// A column of the wide picture tells by its colour where it is, for each eye in its own way.
std::vector<std::uint8_t> columns(EyeSide side) {
    std::vector<std::uint8_t> texels;
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWide; ++x) {
            const auto at = static_cast<std::uint8_t>(side == EyeSide::left ? 3 * x : 255 - 3 * x);
            const auto also = static_cast<std::uint8_t>(at ^ 0x55);
            texels.insert(texels.end(), {at, also, at, 7});
        }
    return texels;
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] const std::uint8_t* at(std::uint32_t x, std::uint32_t y) const { return rgba.data() + (y * kWidth + x) * 4; }
};

/// Both eyes' columns on the surface.
Picture seen(StereoMode mode, std::int32_t shift_px) {
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    StereoPass pass;
    EXPECT_EQ(pass.start(session.gl, session.device.budget, kWidth, kHeight, kMargin).message.view(), "");
    base::BudgetLine line;
    line.bytes = 100'000;
    auto picture = gl::make_texture(session.gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kWide, kHeight});
    test_support::ScreenTriangle triangle(session.gl);
    session.gl.begin_frame();
    for (const EyeSide side : kEyeSides) {
        const auto texels = columns(side);
        EXPECT_TRUE(picture.value().upload(session.gl, {0, 0, kWide, kHeight}, texels.data()));
        pass.target().bind(session.gl);
        triangle.copy(session.gl, picture.value());
        pass.put(session.gl, *session.surface, mode, side, shift_px);
    }
    Picture result{session.pixels()};
    EXPECT_EQ(session.gl.denied().total, 0u);
    picture.value().destroy(session.gl);
    triangle.destroy(session.gl);
    pass.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
    return result;
}

TEST(StereoPass, AnAnaglyphHasEachEyesColorsTexelByTexel) {
    for (const std::int32_t shift : {0, 3, 5}) {
        const Picture both = seen(StereoMode::anaglyph, shift);
        const auto left = columns(EyeSide::left), right = columns(EyeSide::right);
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                const std::uint8_t* const of_left = left.data() + (y * kWide + x + kMargin + static_cast<unsigned>(shift)) * 4;
                const std::uint8_t* const of_right = right.data() + (y * kWide + x + kMargin - static_cast<unsigned>(shift)) * 4;
                ASSERT_EQ(both.at(x, y)[0], of_left[0]) << x;
                ASSERT_EQ(both.at(x, y)[1], of_right[1]) << x;
                ASSERT_EQ(both.at(x, y)[2], of_right[2]) << x;
            }
    }
}

TEST(StereoPass, SideBySideEachHalfHoldsOneEyesScreen) {
    const Picture both = seen(StereoMode::side_by_side, 2);
    constexpr std::uint32_t kHalf = kWidth / 2;
    for (std::uint32_t x = 0; x < kHalf; ++x) {
        const double left = 3 * (2 * x + 0.5 + kMargin + 2), right = 255 - 3 * (2 * x + 0.5 + kMargin - 2);
        EXPECT_NEAR(both.at(x, 3)[0], left, 1.01) << "between two columns";
        EXPECT_NEAR(both.at(x + kHalf, 3)[0], right, 1.01);
    }
}

}  // namespace
}  // namespace tedavis::draw::test_stereo_pass
