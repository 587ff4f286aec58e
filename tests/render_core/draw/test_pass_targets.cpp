#include "render_core/draw/drawers/pass_targets.hpp"

#include <gtest/gtest.h>

#include "render_core/effects/device.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_pass_targets {
namespace {

TEST(PassTargets, StopsAtTheFirstThatHasNoRoomAndNamesTheLine) {
    test_support::GlSession session("egl", "es3-mid", 32, 16);
    base::BudgetLine& line = *session.device.budget.find(effects::kRenderTargets);
    line.bytes = 4 * (8 * 8 + 4 * 4);
    gl::RenderTarget first, second, third;
    PassTargets targets(session.gl, line);
    targets.make(first, 8, 8);
    EXPECT_TRUE(targets.error().message.empty());
    targets.make(second, 8, 8);
    const std::string message = targets.error().message.c_str();
    EXPECT_NE(message.find(line.name.c_str()), std::string::npos) << message;
    targets.make(third, 4, 4);  // which would have room
    EXPECT_TRUE(first.valid());
    EXPECT_FALSE(second.valid());
    EXPECT_FALSE(third.valid());
    EXPECT_EQ(targets.error().message.view(), message);
    EXPECT_EQ(line.use.in_use, 4u * 8 * 8);
    first.destroy(session.gl);
}

}  // namespace
}  // namespace tedavis::draw::test_pass_targets
