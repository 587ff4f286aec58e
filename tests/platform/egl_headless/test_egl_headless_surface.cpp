// What headless EGL must do as a surface stands in tests/contracts; here is what only it does.
#include "platform/egl_headless/egl_headless_surface.hpp"

#include <gtest/gtest.h>

namespace tedavis::platform::test_egl_headless_surface {
namespace {

TEST(EglHeadlessSurface, NeedsNoDisplayVariable) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const auto surface = make_egl_headless_surface({64, 48, ContextLane::es2});
    EXPECT_TRUE(surface.ok()) << surface.error().message.c_str();
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
