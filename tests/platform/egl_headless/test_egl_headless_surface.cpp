// What headless EGL must do as a surface stands in tests/contracts; here is what only it does.
#include "platform/egl_headless/egl_headless_surface.hpp"

#include <gtest/gtest.h>

#include "tests/support/gl_session.hpp"

namespace tedavis::platform::test_egl_headless_surface {
namespace {

TEST(EglHeadlessSurface, NeedsNoDisplayVariable) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const auto surface = make_egl_headless_surface({64, 48, ContextLane::es2});
    EXPECT_TRUE(surface.ok()) << surface.error().message.c_str();
}

TEST(EglHeadlessSurface, ReportsAResetStatusWhereTheDriverIsRobust) {
    test_support::GlSession at("egl", "sc2");
    EXPECT_EQ(at.gl->GetGraphicsResetStatus(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(at.gl.denied().total, 0u);
}

TEST(EglHeadlessSurface, DestroyedWhileCurrentMakesRoomForTheNext) {
    for (int i = 0; i < 2; ++i) {
        const auto made = make_egl_headless_surface({32, 32, ContextLane::es3});
        ASSERT_TRUE(made.ok());
        EXPECT_TRUE(made.value()->make_current());
    }
}

}  // namespace
}  // namespace tedavis::platform::test_egl_headless_surface
