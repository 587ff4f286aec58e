#include "render_core/draw/data/glyph_focus.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/display/foci_of_test.hpp"

namespace tedavis::draw::test_glyph_focus {
namespace {

using test_support::FociOfTest;
using test_support::LoadedScene;

TEST(GlyphFocus, BelowFullDetailFewerGlyphsStandForMore) {
    const FociOfTest foci({R"(context.levels = 0, data = {detail = 0, aggregate = 3, context = "hidden"})"});
    const LoadedScene scene(test_support::small_grid());
    const scene::GlyphFocus focus = glyph_focus(&foci.frame(), {}, scene.layer(), 8);
    ASSERT_EQ(focus.regions, &foci.frame().regions);
    EXPECT_TRUE(focus.hides_context);
    EXPECT_EQ(focus.coarser[scene::GlyphFocus::kSteps], 1);
    EXPECT_NEAR(focus.coarser[scene::GlyphFocus::kSteps / 2], std::sqrt(8), 1e-9);
    EXPECT_NEAR(focus.coarser[0], 8, 1e-9);
    EXPECT_NEAR(focus.across[0], 3, 1e-9);
    EXPECT_NEAR(focus.across[scene::GlyphFocus::kSteps / 2], 2, 1e-9);
    EXPECT_EQ(focus.across[scene::GlyphFocus::kSteps], 1);
    EXPECT_EQ(glyph_focus(nullptr, {}, scene.layer(), 8).regions, nullptr);
}

TEST(GlyphFocus, AFocusForTheShownValuesGoesByThem) {
    const LoadedScene scene(test_support::small_grid());
    const FociOfTest foci(
        {R"(shape = "data", layer = "air", attribute = "temperature", interval = [280, 290], data.size = 0.5)", "radius_m = 900"},
        &scene.scene());
    design::DataElement element;
    element.layer = "air";
    const scene::GlyphFocus focus = glyph_focus(&foci.frame(), element, scene.layer(), 8);
    EXPECT_TRUE(focus.by_value[0]);
    EXPECT_FALSE(focus.by_value[1]);
    EXPECT_EQ(focus.ranges[0].low, 280);
    const LoadedScene masts(test_support::small_points());
    EXPECT_FALSE(glyph_focus(&foci.frame(), element, masts.layer(), 8).by_value[0]) << "of another layer by place";
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_focus
