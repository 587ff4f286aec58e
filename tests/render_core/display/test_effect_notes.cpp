#include "render_core/display/effect_notes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::display::test_effect_notes {
namespace {

/// "name state, replaced_by: reason" of one effect; empty where the record has none of the name.
std::string line_of(const FrameRecord& record, std::string_view name) {
    constexpr const char* kStates[] = {"run", "replaced", "skipped"};
    for (const EffectRecord& effect : record.effects)
        if (effect.name.view() == name)
            return kStates[static_cast<std::size_t>(effect.state)] + (" " + std::string(effect.replaced_by.view())) + ": " +
                   std::string(effect.reason.view());
    return "";
}

class EffectNotes : public ::testing::Test {
protected:
    EffectNotes() {
        decisions_.show_terrain = decisions_.show_warning_colors = true;
        style_.sketch.silhouettes = 1;
        input_.has_silhouettes = true;
    }
    FrameRecord noted() const {
        FrameRecord record;
        note_effects(input_, record);
        return record;
    }

    DisplayDecisions decisions_;
    design::TerrainStyle style_;
    EffectInput input_{decisions_, style_};
};

TEST_F(EffectNotes, WhatIsDrawnRuns) {
    const FrameRecord record = noted();
    EXPECT_EQ(line_of(record, "terrain"), "run : terrain in view");
    EXPECT_EQ(line_of(record, "warning_colors"), "run : height is geometric and valid");
    EXPECT_EQ(line_of(record, "silhouettes"), "run : asked for by the design");
    EXPECT_EQ(line_of(record, "moving_sun"), "") << "not asked for";
    EXPECT_EQ(line_of(record, "drape"), "") << "not asked for";
    EXPECT_EQ(record.terrain_aspect.detail, 1);
}

TEST_F(EffectNotes, WithoutTerrainNothingOfItRuns) {
    decisions_.show_terrain = false;
    input_.light = LightSource::sun;
    input_.drape = DrapeState::shown;
    const FrameRecord record = noted();
    for (const EffectRecord& effect : record.effects) EXPECT_EQ(effect.state, EffectState::skipped) << effect.name.c_str();
    EXPECT_EQ(record.effects.size(), 5u);
    EXPECT_EQ(record.terrain_aspect.technique.view(), "none");
    EXPECT_EQ(record.terrain_aspect.detail, 0);
}

TEST_F(EffectNotes, SilhouettesAreSkippedFromAboveAndReplacedWithoutDepth) {
    input_.has_silhouettes = false;
    EXPECT_EQ(line_of(noted(), "silhouettes"), "skipped : seen from so far away depths hardly differ");
    style_.sketch.silhouettes = 0;
    EXPECT_EQ(line_of(noted(), "silhouettes"), "");
    input_.silhouettes_replaced = true;
    EXPECT_EQ(line_of(noted(), "silhouettes"), "replaced ridges: the device has no 24-bit depth off screen");
}

TEST_F(EffectNotes, TheSunIsReplacedByTheFixedLightWithAReason) {
    input_.light = LightSource::sun;
    EXPECT_EQ(line_of(noted(), "moving_sun"), "run : asked for by the design");
    input_.light = LightSource::no_date;
    EXPECT_EQ(line_of(noted(), "moving_sun"),
              "replaced fixed_light: the time of the flight is no date; name sun_utc in the design");
    input_.light = LightSource::sun_too_low;
    EXPECT_EQ(line_of(noted(), "moving_sun"), "replaced fixed_light: the sun stands below 3 degrees");
}

TEST_F(EffectNotes, AnImageThatIsNotToBeHadLeavesThePlainColour) {
    style_.texture = design::TerrainTexture::image;
    input_.drape = DrapeState::shown;
    const Name with_image = noted().terrain_aspect.technique;
    EXPECT_EQ(line_of(noted(), "drape"), "run : asked for by the design");
    for (const DrapeState missing : {DrapeState::not_in_database, DrapeState::not_on_device}) {
        input_.drape = missing;
        EXPECT_NE(line_of(noted(), "drape").find("the plain colour is drawn"), std::string::npos);
        EXPECT_NE(noted().terrain_aspect.technique.view(), with_image.view());
    }
}

TEST_F(EffectNotes, MembersOneAfterTheOtherAreAnUncertaintysTechnique) {
    design::DataStyle data;
    data.ground.is_shown = true;
    data.ground.members = design::GroundMembers::animated;
    input_.data = &data;
    input_.ground_data = GroundDataState::shown;
    input_.members = 4;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "animated_members");
    EXPECT_NEAR(noted().uncertainty_aspect.detail, 0.5, 1e-9) << "4 of 16";
    data.ground.overlay.technique = design::UncertaintyOverlay::contour;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "animated_members+contour");
    input_.ground_data = GroundDataState::no_members;
    EXPECT_EQ(line_of(noted(), "ground_data"), "skipped : the attribute has no members in the scene");
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "");
}

TEST_F(EffectNotes, MapsBesideThePictureRunWhereTheyHaveDataAndRoom) {
    design::DataStyle data;
    input_.data = &data;
    EXPECT_EQ(line_of(noted(), "adjacent"), "") << "not asked for";
    data.adjacent.is_shown = true;
    data.adjacent.shows = design::AdjacentShows::members;
    input_.adjacent = GroundDataState::shown;
    input_.adjacent_maps = 4;
    EXPECT_EQ(line_of(noted(), "adjacent"), "run : asked for by the design");
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "adjacent_members");
    EXPECT_NEAR(noted().uncertainty_aspect.detail, 0.5, 1e-9);
    data.adjacent.shows = design::AdjacentShows::value;
    EXPECT_EQ(noted().uncertainty_aspect.technique.view(), "") << "values say nothing of it";
    input_.adjacent_maps = 0;
    EXPECT_NE(line_of(noted(), "adjacent").find("skipped : there is no room"), std::string::npos);
    input_.adjacent = GroundDataState::out_of_date;
    EXPECT_NE(line_of(noted(), "adjacent").find("not valid at this time"), std::string::npos);
    input_.adjacent = GroundDataState::not_asked_for;
    EXPECT_NE(line_of(noted(), "adjacent").find("free view"), std::string::npos);
    decisions_.show_terrain = false;
    EXPECT_NE(line_of(noted(), "adjacent").find("failure policy"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::display::test_effect_notes
