#include "render_core/display/planner/element_planner.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render_core/draw/data/traffic_state.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/display/shown_elements.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/flights/sent_traffic.hpp"

namespace tedavis::display::test_element_planner {
namespace {

using design::DataTechnique;
using test_support::kHour_ns;
using test_support::kNoDate;
using test_support::kNow;

using ElementPlannerTest = test_support::ShownElements;
using test_support::scene_draft;

TEST_F(ElementPlannerTest, WhatIsAskedForIsDrawnAndCounted) {
    ask_for("zones", DataTechnique::prism);
    plan();
    EXPECT_EQ(state(0), ElementState::shown);
    EXPECT_EQ(elements_.reports()[0].count.drawn, 2u);
    EXPECT_GT(drawn_pixels(), 50u);
}

TEST_F(ElementPlannerTest, NothingAskedForDrawsNothing) {
    plan();
    EXPECT_FALSE(elements_.has_anything());
    EXPECT_EQ(elements_.reports().size(), 0u);
    EXPECT_EQ(drawn_pixels(), 0u);
}

TEST_F(ElementPlannerTest, WhatIsNotValidNowIsHiddenUntilItIs) {
    ask_for("zones", DataTechnique::prism);
    plan({kNow.ns - 1});
    EXPECT_EQ(state(0), ElementState::out_of_date);
    EXPECT_TRUE(any_is_out_of_date(elements_.reports()));
    EXPECT_FALSE(elements_.has_anything());
    EXPECT_EQ(drawn_pixels(), 0u);
    elements_.plan({ground_, frame_.view, {}, flight::time_of_source(kNow)});
    EXPECT_EQ(state(0), ElementState::shown);
    EXPECT_FALSE(any_is_out_of_date(elements_.reports()));
    EXPECT_GT(drawn_pixels(), 50u);
    elements_.plan({ground_, frame_.view, {}, flight::time_of_source({kNow.ns + kHour_ns + 1})});
    EXPECT_EQ(state(0), ElementState::out_of_date);
    elements_.plan({ground_, frame_.view, {}, flight::time_of_source(kNoDate)});
    EXPECT_EQ(state(0), ElementState::shown) << "a time that is no date makes nothing invalid";
}

/// Eastward across the view for a minute, then at `now`.
struct OwnShip {
    /// With figures of merit of so many metres; 0: it states none.
    explicit OwnShip(double accuracy = 0) : accuracy_m(accuracy) {
        for (int n = 0; n <= 30; ++n) {
            take(n);
            way.step(aircraft, now);
        }
    }
    void take(int n) {
        now = base::Time{} + base::Duration::seconds(100 + 2 * n);
        aircraft.own_ship.position = {base::radians(46.75), base::radians(9.8 + 0.0015 * n), {2600}};
        aircraft.own_ship.state = base::SignalState::valid;
        aircraft.own_ship.height_is_geometric = true;
        aircraft[flight::Signal::wind_speed] = {20, now};
        aircraft[flight::Signal::wind_direction] = {1, now};
        if (!(accuracy_m > 0)) return;
        aircraft[flight::Signal::horizontal_accuracy] = aircraft[flight::Signal::vertical_accuracy] = {accuracy_m, now};
    }
    double accuracy_m;
    flight::FlightTrail way;
    flight::AircraftState aircraft;
    base::Time now;
};

TEST_F(ElementPlannerTest, TheOwnFlightIsShownWithAndWithoutAScene) {
    OwnShip ship;
    for (const bool has_scene : {true, false}) {
        asked_.clear();
        ask_for("", DataTechnique::tube).own = design::OwnData::trail;
        asked_[0].size_m = 100;
        ask_for("", DataTechnique::barbs).own = design::OwnData::wind;
        elements_.set(has_scene ? &scene_.scene() : nullptr, asked_);
        const auto plan_own = [&](const OwnFlightFrame& own) {
            const ElementFrame frame{ground_, frame_.view, {}, flight::time_of_source(kNoDate), own};
            elements_.plan(frame);
            elements_.plan_signs(frame, {});
        };
        plan_own({});
        EXPECT_EQ(state(0), ElementState::not_measured);
        EXPECT_EQ(state(1), ElementState::not_measured);
        EXPECT_EQ(drawn_pixels(), 0u);
        plan_own({&ship.way, &ship.aircraft, ship.now});
        EXPECT_EQ(state(0), ElementState::shown);
        EXPECT_EQ(state(1), ElementState::shown);
        EXPECT_EQ(elements_.reports()[0].count.all(), 32u);
        EXPECT_GT(elements_.reports()[0].count.drawn, 1u);
        EXPECT_EQ(elements_.reports()[1].count.all(), 4u);
        EXPECT_GT(drawn_pixels(), 20u);
        asked_[1].technique = DataTechnique::arrows;
        asked_[0].technique = DataTechnique::prism;
        elements_.set(has_scene ? &scene_.scene() : nullptr, asked_);
        plan_own({&ship.way, &ship.aircraft, ship.now});
        EXPECT_EQ(state(0), ElementState::wrong_layer);
        EXPECT_EQ(state(1), ElementState::wrong_layer);
    }
}

TEST_F(ElementPlannerTest, TheTrailIsAsWideAsItsPlaceIsUnsure) {
    design::DataElement& trail = ask_for("", DataTechnique::tube);
    trail.own = design::OwnData::trail;
    trail.size_m = 20;
    const auto pixels = [&](design::ElementUncertainty uncertainty, double accuracy_m) {
        const OwnShip ship(accuracy_m);
        asked_[0].uncertainty = uncertainty;
        elements_.set(nullptr, asked_);
        elements_.plan({ground_, frame_.view, {}, flight::time_of_source(kNoDate), {&ship.way, &ship.aircraft, ship.now}});
        return drawn_pixels();
    };
    const std::size_t sure = pixels(design::ElementUncertainty::widening, 1),
                      unsure = pixels(design::ElementUncertainty::widening, 300),
                      unstated = pixels(design::ElementUncertainty::widening, 0);
    EXPECT_GT(unsure, 3 * sure);
    EXPECT_GT(unstated, sure) << "unknown must not look certain";
    EXPECT_LE(pixels(design::ElementUncertainty::none, 300), sure) << "control";
}

TEST_F(ElementPlannerTest, NothingIsDrawnAcrossAGapOfTheOwnFlight) {
    OwnShip ship;
    ask_for("", DataTechnique::tube).own = design::OwnData::trail;
    const auto pixels = [&] {
        elements_.set(nullptr, asked_);
        elements_.plan({ground_, frame_.view, {}, flight::time_of_source(kNoDate), {&ship.way, &ship.aircraft, ship.now}});
        return drawn_pixels();
    };
    asked_[0].size_m = 60;
    const std::size_t whole = pixels();
    ship.way = {};
    for (int n = 0; n <= 30; ++n) {
        ship.take(n);
        if (n > 8 && n < 24) ship.aircraft.own_ship.state = base::SignalState::stale;
        ship.way.step(ship.aircraft, ship.now);
    }
    EXPECT_GT(whole, 30u);
    EXPECT_LT(static_cast<double>(pixels()), 0.7 * static_cast<double>(whole));
    EXPECT_EQ(elements_.reports()[0].layer->entry->feature_count, 2u);
}

/// Beside the scene's, by the same techniques, by role and by name, and by the source's own time.
TEST_F(ElementPlannerTest, ReceivedTrafficIsShownWithAndWithoutASceneOrADate) {
    const base::Time now = base::Time{} + base::Duration::seconds(500);
    flight::AircraftState aircraft;
    aircraft.traffic.is_received = true;
    flight::TrafficReport report = test_support::traffic_report(7, now, 46.75, 9.82);
    report.place.height_m = 2600;
    ASSERT_TRUE(aircraft.traffic.reports.try_push_back(report));
    ask_for("", DataTechnique::billboard).role = scene::LayerRole::traffic;
    ask_for("received_traffic", DataTechnique::tube).size_m = 100;
    for (const bool has_scene : {true, false}) {
        elements_.set(has_scene ? &scene_.scene() : nullptr, asked_);
        const auto plan_at = [&](double age_s) {
            const base::Time then = now + base::Duration::from_seconds(age_s);
            const ElementFrame frame{ground_, frame_.view, {}, flight::time_of_source(then), {nullptr, &aircraft, then}};
            elements_.plan(frame);
            elements_.plan_signs(frame, {5});
        };
        plan_at(0);
        ASSERT_EQ(elements_.reports().size(), 2u);
        EXPECT_EQ(state(0), ElementState::shown);
        EXPECT_EQ(elements_.reports()[0].count.drawn, 1u);
        EXPECT_EQ(elements_.reports()[1].count.all(), 2u);
        EXPECT_GT(drawn_pixels(), 20u);
        plan_at(draw::kRemoved_s + 1);
        EXPECT_EQ(elements_.reports()[0].count.drawn, 0u) << "too old, though there is no date";
        plan_at(1);
        EXPECT_EQ(elements_.reports()[0].count.drawn, 1u);
        const flight::Traffic heard = aircraft.traffic;
        aircraft.traffic.reports.clear();
        plan_at(1);
        EXPECT_EQ(state(0), ElementState::not_measured);
        EXPECT_EQ(drawn_pixels(), 0u);
        aircraft.traffic = {};
        plan_at(1);
        EXPECT_EQ(elements_.reports().size(), 1u) << "there is no receiver: the role asks for nothing, the name is said";
        EXPECT_EQ(state(0), ElementState::no_such_layer);
        aircraft.traffic = heard;
    }
}

TEST_F(ElementPlannerTest, LayersThatAreNotThereOrOfAnotherKindAreSaid) {
    ask_for("zoo", DataTechnique::prism);
    ask_for("masts", DataTechnique::prism);
    plan();
    EXPECT_EQ(state(0), ElementState::no_such_layer);
    EXPECT_EQ(state(1), ElementState::wrong_layer);
    EXPECT_FALSE(elements_.has_anything());
}

TEST_F(ElementPlannerTest, ARoleNamesAllItsLayers) {
    design::DataElement& element = ask_for("", DataTechnique::prism);
    element.role = scene::LayerRole::no_go;
    plan();
    ASSERT_EQ(elements_.reports().size(), 1u);
    EXPECT_EQ(elements_.reports()[0].count.all(), 2u);
    asked_[0].role = scene::LayerRole::river;
    plan();
    EXPECT_EQ(elements_.reports().size(), 0u) << "there may be none";
}

TEST_F(ElementPlannerTest, GlyphsAreCountedWhole) {
    design::DataElement& element = ask_for("air", DataTechnique::spheres);
    element.heights_m.clear();
    plan();
    EXPECT_EQ(state(0), ElementState::shown);
    EXPECT_EQ(elements_.reports()[0].count.all(), 12u) << "posts of the lowest level";
}

TEST_F(ElementPlannerTest, OnlyFieldsMayBeSampledMoreSparsely) {
    ask_for("air", DataTechnique::spheres).heights_m.clear();
    ask_for("zones", DataTechnique::prism);
    plan();
    EXPECT_EQ(elements_.counters().features, 2u);
    EXPECT_GT(elements_.counters().glyphs, 0u);
    const draw::ElementCount whole = elements_.reports()[0].count;
    ElementFrame frame{ground_, frame_.view, {255, 0, 255}, flight::time_of_source(kNow)};
    frame.detail_factor = 0.01;
    elements_.plan(frame);
    EXPECT_LE(elements_.reports()[0].count.drawn, whole.drawn);
    EXPECT_GE(elements_.reports()[0].count.aggregated, whole.aggregated);
    EXPECT_EQ(elements_.counters().features, 2u) << "what may not be flown into stays";
    EXPECT_EQ(elements_.reports()[0].detail_factor, 0.01);
    EXPECT_EQ(elements_.reports()[1].detail_factor, 1);
    EXPECT_EQ(elements_.reports()[0].count.all(), 12u) << "none is lost: they are merged or said to be hidden";
    elements_.rest();
    EXPECT_EQ(elements_.counters().features + elements_.counters().glyphs, 0u);
}

TEST_F(ElementPlannerTest, MoreGlyphsThanSlotsAreRefused) {
    for (std::size_t n = 0; n <= GlyphElements::kSlots; ++n) ask_for("air", DataTechnique::spheres);
    plan();
    for (std::size_t n = 0; n < GlyphElements::kSlots; ++n) EXPECT_EQ(state(n), ElementState::shown) << n;
    EXPECT_EQ(state(GlyphElements::kSlots), ElementState::no_room);
}

TEST_F(ElementPlannerTest, AnotherDesignTakesEffectWithTheNextPlan) {
    ask_for("zones", DataTechnique::prism);
    plan();
    EXPECT_GT(drawn_pixels(), 50u);
    asked_.clear();
    plan();
    EXPECT_EQ(drawn_pixels(), 0u);
}

TEST_F(ElementPlannerTest, AnotherSceneLeavesNothingOfTheOneBefore) {
    ask_for("zones", DataTechnique::prism);
    plan();
    host_sim::SceneDraft draft = scene_draft();
    draft.layers.erase(draft.layers.begin() + 2);
    const test_support::LoadedScene other(draft);
    elements_.set(&other.scene(), asked_);
    EXPECT_EQ(elements_.reports().size(), 0u) << "before the next plan nothing points to the old one";
    EXPECT_FALSE(elements_.has_anything());
    elements_.plan({ground_, frame_.view, {}, flight::time_of_source(kNow)});
    EXPECT_EQ(state(0), ElementState::no_such_layer);
    EXPECT_EQ(drawn_pixels(), 0u);
}

TEST_F(ElementPlannerTest, AFrameWithoutTerrainShowsNone) {
    ask_for("zones", DataTechnique::prism);
    plan();
    elements_.rest();
    EXPECT_EQ(state(0), ElementState::no_terrain);
    EXPECT_EQ(drawn_pixels(), 0u);
}

TEST(ElementState, HasAReasonOfItsOwn) {
    std::set<std::string> reasons;
    for (const ElementState state : {ElementState::shown, ElementState::no_such_layer, ElementState::wrong_layer,
                                     ElementState::no_room, ElementState::out_of_date, ElementState::no_terrain})
        reasons.insert(reason_of(state));
    EXPECT_EQ(reasons.size(), 6u);
}

}  // namespace
}  // namespace tedavis::display::test_element_planner
