#include "render_core/draw/drawers/dimmer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render_core/gl/render_target.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_dimmer {
namespace {

class DimmerTest : public ::testing::TestWithParam<const char*> {};

TEST_P(DimmerTest, MultipliesEveryPixelAndLeavesAlpha) {
    test_support::GlSession session("egl", GetParam());
    Dimmer dimmer;
    EXPECT_FALSE(dimmer.is_started());
    ASSERT_EQ(dimmer.start(session.gl, session.device.budget).message.view(), "");
    session.gl.seal();
    session.gl.begin_frame();
    gl::bind_surface(session.gl, *session.surface);
    session.gl->ClearColor(1.0f, 0.5f, 0.2f, 1.0f);
    session.gl->Clear(GL_COLOR_BUFFER_BIT);
    const auto before = session.pixels();
    dimmer.draw(session.gl, {0.5, 0.25, 1});
    const auto after = session.pixels();
    for (std::size_t n = 0; n < after.size(); n += 4) {
        EXPECT_NEAR(after[n], 0.5 * before[n], 1);
        EXPECT_NEAR(after[n + 1], 0.25 * before[n + 1], 1);
        EXPECT_EQ(after[n + 2], before[n + 2]);
        EXPECT_EQ(after[n + 3], before[n + 3]);
    }
    dimmer.draw(session.gl, {1, 1, 1});
    EXPECT_EQ(session.pixels(), after) << "white changes nothing";
    EXPECT_EQ(session.gl.denied().total, 0u);
    dimmer.destroy(session.gl);
}

INSTANTIATE_TEST_SUITE_P(Lanes, DimmerTest, ::testing::Values("es2-small", "es3-mid"));

}  // namespace
}  // namespace tedavis::draw::test_dimmer
