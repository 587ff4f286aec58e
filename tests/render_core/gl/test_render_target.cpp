#include "render_core/gl/render_target.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "render_core/gl/readback.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_render_target {
namespace {

constexpr TextureSettings kSize{TextureFormat::rgba8, TextureFilter::nearest, 20, 10};

class RenderTargetTest : public testing::TestWithParam<const char*> {
protected:
    RenderTargetTest() : at_("egl", GetParam()) { line_.bytes = 10'000; }
    test_support::GlSession at_;
    base::BudgetLine line_;
};

TEST_P(RenderTargetTest, IsDrawnIntoApartFromTheSurface) {
    auto target = make_render_target(at_.gl, line_, kSize, TargetDepth::bits24);
    ASSERT_TRUE(target.ok()) << target.error().message.c_str();
    bind_surface(at_.gl, *at_.surface);
    at_.gl->ClearColor(0, 0, 1, 1);
    at_.gl->Clear(GL_COLOR_BUFFER_BIT);
    target.value().bind(at_.gl);
    at_.gl->ClearColor(1, 0, 0, 1);
    at_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    std::vector<std::uint8_t> inside(20 * 10 * 4);
    ASSERT_TRUE(read_pixels(at_.gl, 20, 10, inside));
    EXPECT_EQ(inside[0], 255);
    EXPECT_EQ(inside[inside.size() - 4], 255);
    bind_surface(at_.gl, *at_.surface);
    EXPECT_EQ(at_.pixels()[2], 255);
    EXPECT_EQ(at_.gl.denied().total, 0u);
}

TEST_P(RenderTargetTest, PaysColorAndDepth) {
    auto target = make_render_target(at_.gl, line_, kSize, TargetDepth::bits24);
    ASSERT_TRUE(target.ok());
    EXPECT_EQ(line_.use.in_use, 20u * 10 * 8);
    RenderTarget moved(std::move(target.value()));
    EXPECT_FALSE(target.value().valid());
    moved.destroy(at_.gl);
    EXPECT_EQ(line_.use.in_use, 0u);
    auto plain = make_render_target(at_.gl, line_, kSize, TargetDepth::none);
    ASSERT_TRUE(plain.ok());
    EXPECT_EQ(line_.use.in_use, 20u * 10 * 4);
}

TEST_P(RenderTargetTest, OverBudgetDepthGivesTheColorBack) {
    line_.bytes = 20 * 10 * 4 + 100;
    const auto target = make_render_target(at_.gl, line_, kSize, TargetDepth::bits24);
    ASSERT_FALSE(target.ok());
    EXPECT_NE(target.error().message.view().find("has 100 of 900 bytes left and 800 are needed"), std::string_view::npos)
        << target.error().message.c_str();
    EXPECT_EQ(line_.use.in_use, 0u);
}

INSTANTIATE_TEST_SUITE_P(Lanes, RenderTargetTest, testing::Values("es2-small", "es3-mid"),
                         [](const auto& device) { return std::string(device.param).substr(0, 3); });

TEST(RenderTargetOnSc2, HasNoDepth) {
    test_support::GlSession at("egl", "sc2");
    base::BudgetLine line;
    line.bytes = 10'000;
    EXPECT_TRUE(make_render_target(at.gl, line, kSize, TargetDepth::none).ok());
    const auto deep = make_render_target(at.gl, line, kSize, TargetDepth::bits24);
    ASSERT_FALSE(deep.ok());
    EXPECT_NE(deep.error().message.view().find("24-bit depth"), std::string_view::npos);
}

}  // namespace
}  // namespace tedavis::gl::test_render_target
