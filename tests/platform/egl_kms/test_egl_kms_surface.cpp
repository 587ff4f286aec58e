// Pictures on a screen are shown on an emulated card (tests/board), and what it does with flips in test_scanout.cpp.
#include "platform/egl_kms/egl_kms_surface.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::platform::test_egl_kms_surface {
namespace {

std::string refusal(const SurfaceSettings& settings, const ScreenSettings& screen) {
    const auto surface = make_egl_kms_surface(settings, screen);
    EXPECT_FALSE(surface.ok());
    return surface.ok() ? "" : surface.error().message.c_str();
}

#if defined(TEDAVIS_HAVE_KMS)

TEST(EglKmsSurface, WhatIsNoScreenIsRefusedInOneSentence) {
    ScreenSettings screen;
    screen.path = "/dev/null";
    EXPECT_EQ(refusal({640, 480, ContextLane::es2}, screen),
              "/dev/null: drives no screens (no KMS); name another card in [screen]");
    screen.path = "/dev/dri/by-path/tedavis-absent";
    EXPECT_NE(refusal({640, 480, ContextLane::es2}, screen).find("there is no such card"), std::string::npos);
    screen.path.clear();
    screen.driver = "tedavis-absent";
    EXPECT_NE(refusal({640, 480, ContextLane::es2}, screen), "");
    EXPECT_NE(refusal({15, 480, ContextLane::es2}, screen).find("16 to 16384 pixels"), std::string::npos);
}

#else

TEST(EglKmsSurface, IsRefusedByABuildWithoutIt) {
    EXPECT_NE(refusal({640, 480, ContextLane::es2}, {}).find("this build shows nothing on a screen"), std::string::npos);
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_egl_kms_surface
