#include "render_core/display/planner/cue_states.hpp"

#include <gtest/gtest.h>

#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/effect_requests.hpp"

namespace tedavis::display::test_cue_states {
namespace {

using effects::Effect;
using Kind = effects::EffectRequest::Kind;

constexpr Effect kAll[] = {Effect::vertical_lines, Effect::projections, Effect::curtains};

design::DataElement with(const design::ElementCues& cues) {
    design::DataElement element;
    element.technique = design::DataTechnique::tube;
    element.cues = cues;
    return element;
}

ElementReport report_of(const design::DataElement& element, ElementState state) {
    ElementReport report;
    report.state = state;
    report.element = &element;
    return report;
}

design::ElementCues every_cue() { return {1000, true, design::LineMotion::along, 50, 0.5, 0.3}; }

TEST(CueStates, TheDesignAsksForThemByTheirTables) {
    design::DesignSettings design;
    for (const Effect effect : kAll) EXPECT_FALSE(effects::asked_effects(design).has(effect));
    ASSERT_TRUE(design.data.elements.try_push_back(with({})));
    for (const Effect effect : kAll) EXPECT_FALSE(effects::asked_effects(design).has(effect));
    ASSERT_TRUE(design.data.elements.try_push_back(with(every_cue())));
    for (const Effect effect : kAll) EXPECT_TRUE(effects::asked_effects(design).has(effect));
    design.data.elements[1].cues = {};
    design.data.elements[1].cues.curtain = 0.2;
    EXPECT_FALSE(effects::asked_effects(design).has(Effect::vertical_lines));
    EXPECT_FALSE(effects::asked_effects(design).has(Effect::projections));
    EXPECT_TRUE(effects::asked_effects(design).has(Effect::curtains));
}

TEST(CueStates, WhatADeviceForbidsIsNotBuilt) {
    design::DesignSettings design;
    ASSERT_TRUE(design.data.elements.try_push_back(with(every_cue())));
    for (const Effect effect : kAll) {
        effects::DeviceSettings device;
        device.forbidden.add(effect);
        const design::DesignSettings possible = effects::possible_design(design, device);
        for (const Effect other : kAll) EXPECT_EQ(effects::asked_effects(possible).has(other), other != effect);
    }
}

TEST(CueStates, StatesAreThoseOfElementsThatAreShown) {
    const design::DataElement element = with(every_cue()), plain = with({});
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(report_of(element, ElementState::out_of_date)));
    ASSERT_TRUE(reports.try_push_back(report_of(plain, ElementState::shown)));
    reports[0].cues[0] = {5, 6};
    EXPECT_FALSE(cue_states(reports)[0].is_shown);
    reports[0].state = ElementState::shown;
    ASSERT_TRUE(reports.try_push_back(report_of(element, ElementState::shown)));
    reports[2].cues[0] = {10, 0};
    const effects::CueState lines = cue_states(reports)[0];
    EXPECT_TRUE(lines.is_shown);
    EXPECT_EQ(lines.drawn, 15u);
    EXPECT_EQ(lines.hidden, 6u);
    EXPECT_TRUE(cue_states(reports)[2].is_shown);
    EXPECT_EQ(cue_states(reports)[2].drawn, 0u);
}

TEST(CueStates, TheRecordSaysWhy) {
    const auto call = [](const effects::CueState& state) {
        effects::EffectFacts facts;
        facts.shows_terrain = true;
        facts.asked.add(Effect::curtains);
        facts.curtains = state;
        return effects::effect_requests(facts)[Effect::curtains];
    };
    EXPECT_EQ(call({}).kind, Kind::not_applicable);
    EXPECT_EQ(call({}).why, "no element that asks for it is shown");
    EXPECT_EQ(call({true, 0, 0}).kind, Kind::not_applicable);
    EXPECT_EQ(call({true, 0, 0}).why, "nothing floats over ground that is known");
    EXPECT_EQ(call({true, 0, 7}).kind, Kind::no_input);
    EXPECT_EQ(call({true, 3, 7}).kind, Kind::applicable);
    EXPECT_NE(call({true, 3, 7}).why, call({true, 3, 0}).why);
}

TEST(CueStates, WhatIsForbiddenIsToldByThePlanner) {
    design::DesignSettings design;
    ASSERT_TRUE(design.data.elements.try_push_back(with(every_cue())));
    effects::EffectFacts facts;
    facts.shows_terrain = true;
    facts.asked = effects::asked_effects(design);
    facts.forbidden.add(Effect::curtains);
    facts.vertical_lines = {true, 8, 0};
    const effects::FramePlan plan = effects::plan_effects(effects::effect_requests(facts), {});
    EXPECT_EQ(plan[Effect::vertical_lines].state, effects::PlanState::run);
    EXPECT_EQ(plan[Effect::projections].state, effects::PlanState::skipped);
    EXPECT_EQ(plan[Effect::curtains].state, effects::PlanState::skipped);
    EXPECT_NE(plan[Effect::curtains].reason, plan[Effect::projections].reason);
}

}  // namespace
}  // namespace tedavis::display::test_cue_states
