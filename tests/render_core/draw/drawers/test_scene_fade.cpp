#include "render_core/draw/drawers/scene_fade.hpp"

#include <gtest/gtest.h>

#include "render_core/effects/device.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_scene_fade {
namespace {

constexpr std::uint32_t kWidth = 16, kHeight = 16;

TEST(SceneFade, MixesWhatWasWithWhatIsByItsShare) {
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    SceneFade fade;
    ASSERT_EQ(fade.start(session.gl, session.device.budget, kWidth, kHeight).message.view(), "");
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, kWidth * kHeight * 8u);
    session.gl.seal();
    session.gl.begin_frame();
    fade.target().bind(session.gl);
    session.gl->ClearColor(200 / 255.0f, 0, 40 / 255.0f, 0.5f);
    session.gl->Clear(GL_COLOR_BUFFER_BIT);
    for (const double share : {0.0, 0.25, 0.5, 1.0}) {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->ClearColor(0, 100 / 255.0f, 40 / 255.0f, 1);
        session.gl->Clear(GL_COLOR_BUFFER_BIT);
        fade.draw(session.gl, share);
        const auto rgba = session.pixels();
        for (std::size_t n = 0; n < rgba.size(); n += 4) {
            ASSERT_NEAR(rgba[n], 200 * share, 1.01);
            ASSERT_NEAR(rgba[n + 1], 100 * (1 - share), 1.01);
            ASSERT_NEAR(rgba[n + 2], 40, 1.01);
            ASSERT_EQ(rgba[n + 3], 255) << "the picture's own alpha";
        }
    }
    EXPECT_EQ(session.gl.denied().total, 0u);
    session.gl.retire();
    fade.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_scene_fade
