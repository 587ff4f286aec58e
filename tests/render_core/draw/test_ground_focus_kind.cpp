#include "render_core/draw/ground_focus_kind.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/focus_grounds.hpp"

namespace tedavis::draw::test_ground_focus_kind {
namespace {

TEST(GroundFocusKind, ProgramsForMoreShowLess) {
    GroundFocusKind built{2, true, false, true};
    EXPECT_TRUE(covers(built, built));
    EXPECT_TRUE(covers(built, {1, false, false, true}));
    EXPECT_FALSE(covers(built, {3, true})) << "more foci";
    EXPECT_FALSE(covers(built, {1, false, true})) << "squares";
    EXPECT_FALSE(covers(built, {})) << "those without foci are others";
    built.blurs = true;
    EXPECT_FALSE(covers(built, {2, true})) << "what they write into alpha differs";
}

TEST(GroundFocusKind, ADesignWithoutALookOrRimOfItsFociHasNone) {
    design::DesignSettings design;
    scene::FocusRegions regions;
    ASSERT_TRUE(regions.try_push_back(scene::focus_region_at(0.8, 0.2)));
    test_support::ask_for(design, regions);
    EXPECT_EQ(ground_focus_kind(design.foci).foci, 1);
    design.foci[0].terrain = {};
    EXPECT_EQ(ground_focus_kind(design.foci).foci, 0);
}

}  // namespace
}  // namespace tedavis::draw::test_ground_focus_kind
