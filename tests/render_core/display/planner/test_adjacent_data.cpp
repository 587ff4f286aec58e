#include "render_core/display/planner/adjacent_data.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/base/units.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_adjacent_data {
namespace {

constexpr std::int64_t kHour_ns = 3'600'000'000'000;
constexpr std::int64_t kDate_ns = 1'700'000'000'000'000'000 / 60'000'000'000 * 60'000'000'000;
constexpr design::Color kSign{200, 40, 200};

class AdjacentDataOf : public ::testing::Test {
protected:
    void start(const host_sim::LayerDraft& layer) {
        host_sim::SceneDraft scene = test_support::small_scene();
        scene.layers[0] = layer;
        scene.layers[0].times_ns = {kDate_ns, kDate_ns + kHour_ns};
        scene.layers[0].valid_until_ns = kDate_ns + 3 * kHour_ns;
        source_.content = host_sim::sdb_bytes(scene);
        EXPECT_EQ(data_.start(&source_, {scene_memory_, slice_memory_}, 64).message.view(), "");
        view_.is_shown = true;
        view_.layer = "air";
        view_.attribute = "temperature";
        view_.scale = test_support::scale_of({});
    }
    AdjacentData plan(std::int64_t time_ns) {
        return plan_adjacent_data(data_, view_, {base::radians(46.9), base::radians(9.5), {0}}, flight::time_of_source({time_ns}),
                                  kSign);
    }

    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 17);
    base::Arena scene_memory_{memory_.data(), 1 << 16}, slice_memory_{memory_.data() + (1 << 16), 1 << 12};
    test_support::FlakyBytes source_{{}};
    SpatialData data_;
    design::AdjacentView view_;
};

TEST_F(AdjacentDataOf, AreTheFieldRoundTheOwnShipAtTheFlightsTime) {
    start(test_support::small_grid());
    const AdjacentData planned = plan(kDate_ns + 90'000'000'000);
    ASSERT_EQ(planned.state, GroundDataState::shown);
    EXPECT_EQ(planned.maps.layer, &data_.scene().layers()[0]);
    EXPECT_EQ(planned.maps.attribute, &data_.scene().layers()[0].attributes[0]);
    EXPECT_EQ(planned.maps.time_ns, kDate_ns + 60'000'000'000) << "whole minutes, as on the ground";
    EXPECT_EQ(planned.maps.height_m, 1000) << "the lowest level";
    EXPECT_EQ(planned.maps.latitude_rad, base::radians(46.9));
    EXPECT_EQ(planned.maps.title.view(), "TEMPERATURE");
    view_.height_m = 3000;
    EXPECT_EQ(plan(kDate_ns).maps.height_m, 3000);
    view_.layer = "";
    EXPECT_EQ(plan(kDate_ns).maps.layer, planned.maps.layer) << "the first grid of the role";
    EXPECT_EQ(plan(5).maps.time_ns, kDate_ns) << "a source without a date shows their first time";
}

TEST_F(AdjacentDataOf, WhatCannotBeShownIsSaidAndHasNoMaps) {
    const auto state_without_maps = [this](std::int64_t time_ns = kDate_ns) {
        const AdjacentData planned = plan(time_ns);
        EXPECT_EQ(draw::map_count(planned.maps), 0u);
        return planned.state;
    };
    view_.is_shown = true;
    EXPECT_EQ(state_without_maps(), GroundDataState::no_scene);
    start(test_support::small_grid());
    EXPECT_EQ(draw::map_count(plan(kDate_ns).maps), 1u) << "negative control";
    EXPECT_EQ(state_without_maps(kDate_ns + 4 * kHour_ns), GroundDataState::out_of_date);
    view_.shows = design::AdjacentShows::members;
    EXPECT_EQ(state_without_maps(), GroundDataState::no_members);
    view_.attribute = "pressure";
    EXPECT_EQ(state_without_maps(), GroundDataState::no_such_attribute);
    view_.layer = "masts";
    EXPECT_EQ(state_without_maps(), GroundDataState::too_large) << "no grid";
    view_.layer = "nothing";
    EXPECT_EQ(state_without_maps(), GroundDataState::no_such_layer);
    view_.layer = "";
    view_.role = scene::LayerRole::obstacle;
    EXPECT_EQ(state_without_maps(), GroundDataState::no_such_layer) << "masts are no grid";
    view_.is_shown = false;
    EXPECT_EQ(state_without_maps(), GroundDataState::not_asked_for);
}

TEST_F(AdjacentDataOf, TheLegendSaysWhatTheColorsAndTheSignsMean) {
    start(test_support::small_ensemble());
    const auto legend = [this](design::AdjacentShows shows) {
        view_.shows = shows;
        draw::DataLegends legends;
        add_adjacent_legend(plan(kDate_ns), flight::time_of_source({kDate_ns}), {}, legends);
        EXPECT_EQ(legends.size(), 1u);
        return legends.empty() ? draw::DataLegend() : legends[0];
    };
    const draw::DataLegend unsure = legend(design::AdjacentShows::uncertainty);
    EXPECT_EQ(unsure.title.view(), "AIR TEMPERATURE \xC2\xB1");
    EXPECT_EQ(unsure.factor, 4) << "a level of 1 is 4 K";
    EXPECT_EQ(unsure.scale.palette.name.view(), "grey");
    ASSERT_EQ(unsure.signs.size(), 3u);
    EXPECT_EQ(unsure.signs[0].text.view(), "UNKNOWN");
    EXPECT_EQ(unsure.signs[0].under, kSign);
    const draw::DataLegend members = legend(design::AdjacentShows::members);
    EXPECT_EQ(members.title.view(), "AIR TEMPERATURE");
    ASSERT_EQ(members.signs.size(), 2u);
    EXPECT_EQ(members.signs[0].text.view(), "MISSING");
    EXPECT_EQ(members.signs[1].text.view(), "INTERPOLATED");
    draw::DataLegends none;
    view_.is_shown = false;
    add_adjacent_legend(plan(kDate_ns), flight::time_of_source({kDate_ns}), {}, none);
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace tedavis::display::test_adjacent_data
