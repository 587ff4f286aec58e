// What OSMesa must do as a surface stands in tests/contracts; here is what only it does.
#include "platform/osmesa/osmesa_surface.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <vector>

namespace tedavis::platform::test_osmesa_surface {
namespace {

#if defined(TEDAVIS_HAVE_OSMESA)

TEST(OsmesaSurface, KeepsItsGlNamesOutOfTheProcess) {
    const auto surface = make_osmesa_surface({64, 48, ContextLane::es3});
    ASSERT_TRUE(surface.ok()) << surface.error().message.c_str();
    EXPECT_EQ(dlsym(RTLD_DEFAULT, "glClear"), nullptr) << "a global gl* name would shadow EGL's";
}

TEST(OsmesaSurface, ManyMayExistOneAfterTheOtherIsCurrent) {
    std::vector<std::unique_ptr<base::Surface>> surfaces;
    for (int i = 0; i < 3; ++i) {
        auto made = make_osmesa_surface({32, 32, ContextLane::es3});
        ASSERT_TRUE(made.ok());
        surfaces.push_back(std::move(made.value()));
    }
    for (const auto& surface : surfaces) {
        ASSERT_TRUE(surface->make_current());
        EXPECT_NE(surface->proc_address("glClear"), nullptr);
        surface->release_current();
    }
}

TEST(OsmesaSurface, DestroyedWhileCurrentMakesRoomForTheNext) {
    for (int i = 0; i < 2; ++i) {
        const auto made = make_osmesa_surface({32, 32, ContextLane::es3});
        ASSERT_TRUE(made.ok());
        EXPECT_TRUE(made.value()->make_current());
    }
}

#else

TEST(OsmesaSurface, IsRefusedByABuildWithoutIt) {
    const auto surface = make_osmesa_surface({64, 48, ContextLane::es3});
    ASSERT_FALSE(surface.ok());
    EXPECT_NE(surface.error().message.view().find("this build has no OSMesa"), std::string_view::npos);
}

#endif

}  // namespace
}  // namespace tedavis::platform::test_osmesa_surface
