#include "platform/egl_headless/egl_display.hpp"

#include <gtest/gtest.h>

namespace tedavis::platform::test_egl_display {
namespace {

TEST(EglExtension, MatchesWholeWords) {
    EXPECT_TRUE(has_egl_extension("EGL_A EGL_B EGL_C", "EGL_B"));
    EXPECT_TRUE(has_egl_extension("EGL_AB EGL_A", "EGL_A"));
    EXPECT_FALSE(has_egl_extension("EGL_AB XEGL_A", "EGL_A"));
    EXPECT_FALSE(has_egl_extension(nullptr, "EGL_A"));
    EXPECT_FALSE(has_egl_extension("EGL_A", ""));
}

TEST(HeadlessDisplay, IsFoundAndIsTheSameAgain) {
    const EGLDisplay display = find_headless_display();
    ASSERT_NE(display, EGL_NO_DISPLAY);
    EXPECT_EQ(find_headless_display(), display);
}

TEST(HeadlessConfig, HasEightBitsAColorAnd24OfDepthInBothLanes) {
    const EGLDisplay display = find_headless_display();
    for (int version : {2, 3}) {
        const EGLConfig config = find_headless_config(display, version);
        ASSERT_NE(config, nullptr);
        EGLint value = 0;
        eglGetConfigAttrib(display, config, EGL_DEPTH_SIZE, &value);
        EXPECT_GE(value, 24);
        for (EGLint size : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE}) {
            eglGetConfigAttrib(display, config, size, &value);
            EXPECT_EQ(value, 8);
        }
        eglGetConfigAttrib(display, config, EGL_SAMPLES, &value);
        EXPECT_EQ(value, 0) << "pictures must not depend on a multisampling default";
    }
}

}  // namespace
}  // namespace tedavis::platform::test_egl_display
