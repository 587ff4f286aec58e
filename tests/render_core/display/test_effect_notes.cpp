#include "render_core/display/effect_notes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace tedavis::display::test_effect_notes {
namespace {

using effects::Effect;
using Kind = effects::EffectRequest::Kind;

/// "name state, replaced_by: reason" of one effect; empty where the record has none of the name.
std::string line_of(const FrameRecord& record, std::string_view name) {
    constexpr const char* kStates[] = {"run", "replaced", "skipped"};
    for (const EffectRecord& effect : record.effects)
        if (effect.name.view() == name)
            return kStates[static_cast<std::size_t>(effect.state)] + (" " + std::string(effect.replaced_by.view())) + ": " +
                   std::string(effect.reason.view());
    return "";
}

class EffectNotesTest : public ::testing::Test {
protected:
    EffectNotesTest() {
        decisions_.show_terrain = decisions_.show_warning_colors = true;
        call(Effect::terrain, Kind::applicable, "terrain in view");
        design_.terrain.style.texture = design::TerrainTexture::image;
    }
    void call(Effect effect, Kind kind, std::string_view why = {}, double bound = std::numeric_limits<double>::infinity()) {
        input_[effect] = {kind, why, bound};
    }
    [[nodiscard]] FrameRecord noted() const {
        FrameRecord record;
        const effects::FramePlan plan = plan_effects(input_, device_);
        record_effects({plan, decisions_, design_, members_, maps_}, record);
        return record;
    }

    effects::PlanInput input_;
    effects::DeviceCapability device_;
    policy::DisplayDecisions decisions_;
    design::DesignSettings design_;
    std::uint32_t members_ = 0, maps_ = 0;
};

TEST_F(EffectNotesTest, ThePlanIsInTheRecordWithItsReasons) {
    call(Effect::silhouettes, Kind::applicable);
    call(Effect::warning_colors, Kind::not_applicable, "height not to be trusted");
    call(Effect::haze, Kind::applicable, "", 0.003);
    device_.depth24_targets = false;
    const FrameRecord record = noted();
    EXPECT_EQ(line_of(record, "terrain"), "run : terrain in view");
    EXPECT_EQ(line_of(record, "warning_colors"), "skipped : height not to be trusted");
    EXPECT_EQ(line_of(record, "silhouettes"), "replaced ridges: the device has no 24-bit depth off screen");
    EXPECT_EQ(line_of(record, "haze"), "skipped : too small to be seen");
    EXPECT_EQ(line_of(record, "moving_sun"), "") << "not asked for";
    ASSERT_EQ(record.effects.size(), 4u);
    EXPECT_EQ(record.effects[3].bound, 0.003);
}

TEST_F(EffectNotesTest, TheAspectOfTerrainIsItsStyle) {
    call(Effect::drape, Kind::applicable);
    const auto with_image = noted().terrain_aspect.technique;
    EXPECT_EQ(noted().terrain_aspect.detail, 1);
    call(Effect::drape, Kind::no_input, "there is no image");
    EXPECT_NE(noted().terrain_aspect.technique.view(), with_image.view());
    EXPECT_EQ(noted().terrain_aspect.technique.view().find("plain"), 0u);
    decisions_.show_terrain = false;
    EXPECT_EQ(noted().terrain_aspect.technique.view(), "none");
    EXPECT_EQ(noted().terrain_aspect.detail, 0);
}

TEST_F(EffectNotesTest, MembersOneAfterTheOtherAreAnUncertaintysTechnique) {
    design_.data.ground.is_shown = true;
    design_.data.ground.members = design::GroundMembers::animated;
    call(Effect::ground_data, Kind::applicable);
    members_ = 4;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "animated_members");
    EXPECT_NEAR(noted().uncertainty_aspect.detail, 0.5, 1e-9) << "4 of 16";
    design_.data.ground.overlay.technique = design::UncertaintyOverlay::contour;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "animated_members+contour");
    call(Effect::ground_data, Kind::no_input, "the attribute has no members in the scene");
    EXPECT_EQ(line_of(noted(), "ground_data"), "skipped : the attribute has no members in the scene");
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "");
}

TEST_F(EffectNotesTest, MapsBesideThePictureAddTheirAspect) {
    design_.data.adjacent.is_shown = true;
    design_.data.adjacent.shows = design::AdjacentShows::members;
    maps_ = 4;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "") << "not planned";
    call(Effect::adjacent, Kind::applicable);
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "adjacent_members");
    EXPECT_NEAR(noted().uncertainty_aspect.detail, 0.5, 1e-9);
    design_.data.adjacent.shows = design::AdjacentShows::value;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "") << "values say nothing of it";
}

}  // namespace
}  // namespace tedavis::display::test_effect_notes
