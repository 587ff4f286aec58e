#include "render_core/display/shadow_casters.hpp"

#include "tests/support/display/shaded_view.hpp"

namespace tedavis::display::test_shadow_casters {
namespace {

using ShadowCastersOfView = test_support::ShadedView;

TEST_F(ShadowCastersOfView, OnlyLevelsInWhichSomethingCastsAreDrawn) {
    EXPECT_EQ(casters_.draw(session_.gl, {{&solids_, &solids_}}, set(), plan().frame, view_.eye), 0u);
    EXPECT_EQ(session_.gl.frame().draws, 0u);
    add_plate(1000, 50);
    EXPECT_TRUE(solids_.upload(session_.gl));
    EXPECT_EQ(casters_.draw(session_.gl, {{&solids_, &solids_}}, set(), plan().frame, view_.eye), 2 * draw::kShadowLevels)
        << "the same batch twice";
    solids_.batch().clear();
    add_plate(20'000, 50);
    EXPECT_TRUE(solids_.upload(session_.gl));
    EXPECT_EQ(casters_.draw(session_.gl, {{&solids_, &solids_}}, set(), plan().frame, view_.eye), 2u) << "the widest alone";
    EXPECT_EQ(session_.gl.denied().total, 0u);
}

}  // namespace
}  // namespace tedavis::display::test_shadow_casters
