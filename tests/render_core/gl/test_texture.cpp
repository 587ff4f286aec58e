#include "render_core/gl/texture.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "render_core/gl/render_target.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_texture {
namespace {

class TextureTest : public testing::TestWithParam<const char*> {
protected:
    TextureTest() : at_("egl", GetParam(), 32, 32) { line_.bytes = 100'000; }

    std::vector<std::uint8_t> show(const Texture& texture) {
        test_support::ScreenTriangle triangle(at_.gl);
        bind_surface(at_.gl, *at_.surface);
        triangle.copy(at_.gl, texture);
        std::vector<std::uint8_t> pixels = at_.pixels();
        triangle.destroy(at_.gl);
        return pixels;
    }

    test_support::GlSession at_;
    base::BudgetLine line_;
};

TEST_P(TextureTest, ShowsTheTexelsOfEveryFormat) {
    for (TextureFormat format : {TextureFormat::r8, TextureFormat::rgba8}) {
        const std::size_t step = format == TextureFormat::rgba8 ? 4 : 1;
        auto texture = make_texture(at_.gl, line_, {format, TextureFilter::nearest, 32, 32});
        ASSERT_TRUE(texture.ok()) << texture.error().message.c_str();
        std::vector<std::uint8_t> texels(32 * 32 * step);
        for (std::size_t i = 0; i < 32 * 32; ++i) texels[i * step] = static_cast<std::uint8_t>(i * 7);
        ASSERT_TRUE(texture.value().upload(at_.gl, {0, 0, 32, 32}, texels.data()));
        const auto pixels = show(texture.value());
        for (std::size_t i = 0; i < 32 * 32; ++i) ASSERT_EQ(pixels[i * 4], static_cast<std::uint8_t>(i * 7)) << i;
        texture.value().destroy(at_.gl);
    }
    EXPECT_EQ(at_.gl.denied().total, 0u);
}

/// Whether or not the surface has alpha.
TEST_P(TextureTest, TakesRowsOfWhatIsBound) {
    auto texture = make_texture(at_.gl, line_, {TextureFormat::rgba8, TextureFilter::nearest, 32, 32});
    auto copy = make_texture(at_.gl, line_, {TextureFormat::rgb8, TextureFilter::nearest, 32, 32});
    ASSERT_TRUE(texture.ok() && copy.ok());
    EXPECT_EQ(line_.use.in_use, 2u * 32 * 32 * 4) << "as drivers store it";
    std::vector<std::uint8_t> texels(32 * 32 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 11 / 4);
    ASSERT_TRUE(texture.value().upload(at_.gl, {0, 0, 32, 32}, texels.data()));
    const auto whole = show(texture.value());
    copy.value().copy_rows(at_.gl, 5, 20, 9);
    const auto copied = show(copy.value());
    for (std::size_t row = 5; row < 14; ++row)
        for (std::size_t i = 0; i < 32; ++i)
            for (std::size_t channel = 0; channel < 3; ++channel)
                ASSERT_EQ(copied[(row * 32 + i) * 4 + channel], whole[((row + 15) * 32 + i) * 4 + channel]) << row;
    EXPECT_EQ(at_.gl.denied().total, 0u);
    EXPECT_EQ(at_.gl.take_error(), GLenum{GL_NO_ERROR});
    copy.value().destroy(at_.gl);
    texture.value().destroy(at_.gl);
}

TEST_P(TextureTest, UploadsStayInside) {
    auto texture = make_texture(at_.gl, line_, {TextureFormat::rgba8, TextureFilter::linear, 16, 8});
    ASSERT_TRUE(texture.ok());
    const std::vector<std::uint8_t> texels(16 * 8 * 4);
    EXPECT_TRUE(texture.value().upload(at_.gl, {15, 7, 1, 1}, texels.data()));
    EXPECT_FALSE(texture.value().upload(at_.gl, {16, 7, 1, 1}, texels.data()));
    EXPECT_FALSE(texture.value().upload(at_.gl, {0, 1, 16, 8}, texels.data()));
    EXPECT_FALSE(texture.value().upload(at_.gl, {0xFFFFFFFFu, 0, 2, 1}, texels.data()));
    EXPECT_EQ(at_.gl.frame().uploaded_bytes, 4u);
}

TEST_P(TextureTest, TakesItsBytesFromTheLine) {
    EXPECT_EQ(texture_bytes({TextureFormat::rgba8, TextureFilter::nearest, 16, 8}), 512u);
    EXPECT_EQ(texture_bytes({TextureFormat::r8, TextureFilter::nearest, 16, 8}), 128u);
    line_.bytes = 600;
    auto texture = make_texture(at_.gl, line_, {TextureFormat::rgba8, TextureFilter::nearest, 16, 8});
    ASSERT_TRUE(texture.ok());
    EXPECT_EQ(line_.use.in_use, 512u);
    EXPECT_FALSE(make_texture(at_.gl, line_, {TextureFormat::r8, TextureFilter::nearest, 16, 8}).ok());
    texture.value().destroy(at_.gl);
    EXPECT_EQ(line_.use.in_use, 0u);
}

TEST_P(TextureTest, HalfFloatsAreOfES3Only) {
    const bool is_es3 = at_.device.capability.gl.calls == effects::CallClass::es3;
    auto texture = make_texture(at_.gl, line_, {TextureFormat::rgba16f, TextureFilter::linear, 2, 2});
    ASSERT_EQ(texture.ok(), is_es3);
    if (!is_es3) return;
    EXPECT_EQ(line_.use.in_use, 32u);
    const std::uint16_t half = 0x3800, texels[] = {half, 0, 0, 0, half, 0, 0, 0, half, 0, 0, 0, half, 0, 0, 0};
    ASSERT_TRUE(texture.value().upload(at_.gl, {0, 0, 2, 2}, texels));
    EXPECT_NEAR(show(texture.value())[0], 127.5, 0.6);
    texture.value().destroy(at_.gl);
}

/// That they arrive as they are is seen by their readers (draw/drawers/geometry_picture).
TEST_P(TextureTest, WordsAreOfES3Only) {
    const bool is_es3 = at_.device.capability.gl.calls == effects::CallClass::es3;
    auto texture = make_texture(at_.gl, line_, {TextureFormat::rgba32ui, TextureFilter::nearest, 2, 3});
    ASSERT_EQ(texture.ok(), is_es3);
    if (!is_es3) return;
    EXPECT_EQ(line_.use.in_use, 96u);
    const std::uint32_t texels[24] = {};
    ASSERT_TRUE(texture.value().upload(at_.gl, {0, 0, 2, 3}, texels));
    EXPECT_EQ(at_.gl.take_error(), GLenum{GL_NO_ERROR});
    EXPECT_EQ(at_.gl.denied().total, 0u);
    texture.value().destroy(at_.gl);
}

TEST_P(TextureTest, LargerThanTheDeviceIsRefusedAndTakesNothing) {
    line_.bytes = 1u << 30;
    const auto texture =
        make_texture(at_.gl, line_, {TextureFormat::r8, TextureFilter::nearest, at_.device.capability.gl.max_texture_px + 1, 4});
    ASSERT_FALSE(texture.ok());
    EXPECT_NE(texture.error().message.view().find("refused a texture of"), std::string_view::npos);
    EXPECT_EQ(line_.use.in_use, 0u);
    EXPECT_FALSE(make_texture(at_.gl, line_, {TextureFormat::r8, TextureFilter::nearest, 0, 4}).ok());
}

INSTANTIATE_TEST_SUITE_P(Lanes, TextureTest, testing::Values("es2-small", "es3-mid"),
                         [](const auto& device) { return std::string(device.param).substr(0, 3); });

}  // namespace
}  // namespace tedavis::gl::test_texture
