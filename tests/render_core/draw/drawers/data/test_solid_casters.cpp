#include "render_core/draw/drawers/data/solid_casters.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_solid_casters {
namespace {

/// What it draws is held against places on the ground in test_shadow_map.cpp.
TEST(SolidCasters, StartAndEndInEveryLaneThatHasThem) {
    for (const char* const device : {"es2-small", "es3-mid"}) {
        test_support::GlSession session("egl", device);
        SolidCasters casters;
        EXPECT_FALSE(casters.is_started());
        EXPECT_EQ(casters.start(session.gl).message.view(), "") << device;
        EXPECT_TRUE(casters.is_started());
        casters.destroy(session.gl);
        EXPECT_FALSE(casters.is_started());
    }
}

}  // namespace
}  // namespace tedavis::draw::test_solid_casters
