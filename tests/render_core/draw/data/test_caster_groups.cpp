#include "render_core/draw/data/caster_groups.hpp"

#include <gtest/gtest.h>

namespace tedavis::draw::test_caster_groups {
namespace {

TEST(CasterGroups, ThingsOverTheGroundCastShadowsAndNothingElseDoes) {
    SolidPiece thing;
    thing.look.group = 3;
    const CasterGroups shown{1u << 3, 0};
    EXPECT_TRUE(casts_shadow(thing, shown));
    EXPECT_FALSE(casts_shadow(thing, {1u << 2, 0})) << "not of a role that is named";
    SolidPiece margin = thing, rim = thing, strip = thing, nothing = thing, faint = thing;
    margin.look.is_thing = false;
    rim.look.halo_px = 1;
    strip.look.raised_px = 1;
    nothing.look.opacity = 0;
    faint.look.opacity = 0.1f;
    for (const SolidPiece& piece : {margin, rim, strip, nothing}) EXPECT_FALSE(casts_shadow(piece, shown));
    EXPECT_TRUE(casts_shadow(faint, shown)) << "faintly";
}

}  // namespace
}  // namespace tedavis::draw::test_caster_groups
