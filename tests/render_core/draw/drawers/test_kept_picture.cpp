#include "render_core/draw/drawers/kept_picture.hpp"

#include <gtest/gtest.h>

#include "render_core/effects/device.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_kept_picture {
namespace {

constexpr std::uint32_t kWidth = 32, kHeight = 16, kWide = 48;

TEST(KeptPicture, PutsColumnForColumnWhatIsAskedFor) {
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    KeptPicture picture;
    ASSERT_EQ(picture.start(session.gl, session.device.budget, kWide, kHeight).message.view(), "");
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, kWide * kHeight * 8u);
    session.gl.seal();
    session.gl.begin_frame();
    picture.target().bind(session.gl);
    session.gl->Enable(GL_SCISSOR_TEST);
    for (std::uint32_t x = 0; x < kWide; ++x) {  // a column's red is its number
        session.gl->Scissor(static_cast<GLint>(x), 0, 1, static_cast<GLsizei>(kHeight));
        session.gl->ClearColor(static_cast<float>(5 * x) / 255, 0.5f, 0, 1);
        session.gl->Clear(GL_COLOR_BUFFER_BIT);
    }
    session.gl->Disable(GL_SCISSOR_TEST);
    for (const std::uint32_t begins : {0u, 7u, 16u}) {
        gl::bind_surface(session.gl, *session.surface);
        picture.draw(session.gl, static_cast<std::int32_t>(begins), kWidth);
        const auto rgba = session.pixels();
        for (std::size_t n = 0; n < rgba.size(); n += 4) ASSERT_EQ(rgba[n], 5 * (n / 4 % kWidth + begins));
    }
    EXPECT_EQ(session.gl.denied().total, 0u);
    session.gl.retire();
    picture.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_kept_picture
