#include "render_core/display/planner/symbology_data.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::display::test_symbology_data {
namespace {

class SymbologyDataOf : public ::testing::Test {
protected:
    SymbologyDataOf() {
        symbology_ = test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480);
        symbology_.adjacent.layer = &loaded_.layer();
        symbology_.adjacent.attribute = &loaded_.attribute();
        symbology_.adjacent.view.size = 5;
        symbology_.adjacent.view.scale = test_support::wind().scale;
    }
    std::string flags(GroundDataState state = GroundDataState::shown) const {
        FrameRecord record;
        flag_symbology_data(symbology_, layout(), state, record);
        std::string all;
        for (const Name& name : record.flags) all += std::string(name.view()) + " ";
        return all;
    }
    [[nodiscard]] draw::Layout layout() const { return draw::make_layout(640, 480, 96, draw::legend_need(symbology_)); }

    test_support::LoadedScene loaded_{test_support::small_ensemble(9)};
    draw::SymbologyInput symbology_;
};

TEST_F(SymbologyDataOf, MapsWithRoomAreCountedAndRaiseNothing) {
    EXPECT_EQ(flags(), "");
    EXPECT_EQ(maps_drawn(symbology_, layout()), 1u);
    symbology_.adjacent.view.shows = design::AdjacentShows::members;
    EXPECT_EQ(maps_drawn(symbology_, layout()), 9u);
    symbology_.decisions.unusual_attitude = true;
    EXPECT_EQ(maps_drawn(symbology_, layout()), 0u) << "a recovery picture has none";
    EXPECT_EQ(flags(), "");
}

TEST_F(SymbologyDataOf, WhatHasNoRoomNoDataOrAnotherUnitIsFlagged) {
    EXPECT_EQ(flags(GroundDataState::no_members), "adjacent.missing ");
    EXPECT_EQ(flags(GroundDataState::not_asked_for), "");
    symbology_.adjacent.view.shows = design::AdjacentShows::value;
    symbology_.adjacent.view.scale.palette.unit = design::PaletteUnit::metres;
    EXPECT_EQ(flags(), "adjacent.unit ");
    symbology_.adjacent.view.shows = design::AdjacentShows::members;
    symbology_.adjacent.view.scale.palette.unit = design::PaletteUnit::one;
    symbology_.legend.highest = 2000;
    symbology_.legend.tint = symbology_.legend.bands = true;
    using test_support::wind;
    symbology_.data_legends = test_support::list_of({wind(), wind(), wind()});
    EXPECT_TRUE(layout().adjacent.empty());
    EXPECT_EQ(maps_drawn(symbology_, layout()), 0u);
    EXPECT_EQ(flags(), "adjacent.cut ") << "legends are never given up for maps";
}

}  // namespace
}  // namespace tedavis::display::test_symbology_data
