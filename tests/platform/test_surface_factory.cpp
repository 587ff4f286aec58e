#include "platform/surface_factory.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::platform::test_surface_factory {
namespace {

TEST(SurfaceFactory, MakesEveryBackendOfTheBuild) {
    for (const std::string& backend : test_support::headless_backends()) {
        const auto surface = make_surface(backend, {64, 48, ContextLane::es2});
        ASSERT_TRUE(surface.ok()) << surface.error().message.c_str();
        EXPECT_EQ(surface.value()->backend_name(), backend);
    }
}

TEST(SurfaceFactory, RefusesInOneSentence) {
    const auto unknown = make_surface("glut", {64, 48, ContextLane::es3});
    ASSERT_FALSE(unknown.ok());
    EXPECT_STREQ(unknown.error().message.c_str(), "the surface 'glut' is not known; use egl or osmesa");
    for (const SurfaceSettings& size :
         {SurfaceSettings{0, 48, ContextLane::es3}, SurfaceSettings{64, 15, ContextLane::es3},
          SurfaceSettings{64, 20000, ContextLane::es3}, SurfaceSettings{4294967295u, 48, ContextLane::es3}}) {
        const auto surface = make_surface("egl", size);
        ASSERT_FALSE(surface.ok());
        EXPECT_NE(surface.error().message.view().find("--size"), std::string_view::npos);
    }
}

}  // namespace
}  // namespace tedavis::platform::test_surface_factory
