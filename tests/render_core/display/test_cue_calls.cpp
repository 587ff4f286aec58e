#include "render_core/display/cue_calls.hpp"

#include <gtest/gtest.h>

#include "render_core/display/effect_calls.hpp"

namespace tedavis::display::test_cue_calls {
namespace {

using effects::Effect;
using Kind = effects::EffectCall::Kind;

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

TEST(CueCalls, TheDesignAsksForThemByTheirTables) {
    design::DesignSettings design;
    for (const Effect effect : kAll) EXPECT_FALSE(asked_effects(design).has(effect));
    ASSERT_TRUE(design.data.elements.try_push_back(with({})));
    for (const Effect effect : kAll) EXPECT_FALSE(asked_effects(design).has(effect));
    ASSERT_TRUE(design.data.elements.try_push_back(with(every_cue())));
    for (const Effect effect : kAll) EXPECT_TRUE(asked_effects(design).has(effect));
    design.data.elements[1].cues = {};
    design.data.elements[1].cues.curtain = 0.2;
    EXPECT_FALSE(asked_effects(design).has(Effect::vertical_lines));
    EXPECT_FALSE(asked_effects(design).has(Effect::projections));
    EXPECT_TRUE(asked_effects(design).has(Effect::curtains));
}

TEST(CueCalls, WhatADeviceForbidsIsNotBuilt) {
    design::DesignSettings design;
    ASSERT_TRUE(design.data.elements.try_push_back(with(every_cue())));
    for (const Effect effect : kAll) {
        effects::DeviceSettings device;
        device.forbidden.add(effect);
        const design::DesignSettings possible = possible_design(design, device);
        for (const Effect other : kAll) EXPECT_EQ(asked_effects(possible).has(other), other != effect);
    }
}

TEST(CueCalls, StatesAreThoseOfElementsThatAreShown) {
    const design::DataElement element = with(every_cue()), plain = with({});
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(report_of(element, ElementState::out_of_date)));
    ASSERT_TRUE(reports.try_push_back(report_of(plain, ElementState::shown)));
    reports[0].cues[0] = {5, 6};
    EXPECT_FALSE(cue_states(reports)[0].is_shown);
    reports[0].state = ElementState::shown;
    ASSERT_TRUE(reports.try_push_back(report_of(element, ElementState::shown)));
    reports[2].cues[0] = {10, 0};
    const CueState lines = cue_states(reports)[0];
    EXPECT_TRUE(lines.is_shown);
    EXPECT_EQ(lines.drawn, 15u);
    EXPECT_EQ(lines.hidden, 6u);
    EXPECT_TRUE(cue_states(reports)[2].is_shown);
    EXPECT_EQ(cue_states(reports)[2].drawn, 0u);
}

TEST(CueCalls, TheRecordSaysWhy) {
    EXPECT_EQ(cue_call({}, false).kind, Kind::not_called_for);
    EXPECT_EQ(cue_call({}, false).why, "no element that asks for it is shown");
    EXPECT_EQ(cue_call({true, 0, 0}, false).kind, Kind::not_called_for);
    EXPECT_EQ(cue_call({true, 0, 0}, false).why, "nothing floats over ground that is known");
    EXPECT_EQ(cue_call({true, 0, 7}, false).kind, Kind::no_input);
    EXPECT_EQ(cue_call({true, 3, 7}, false).kind, Kind::called);
    EXPECT_NE(cue_call({true, 3, 7}, false).why, cue_call({true, 3, 0}, false).why);
}

TEST(CueCalls, WhatIsForbiddenIsToldByThePlanner) {
    design::DesignSettings design;
    ASSERT_TRUE(design.data.elements.try_push_back(with(every_cue())));
    policy::DisplayDecisions decisions;
    decisions.show_terrain = true;
    EffectFacts facts{asked_effects(design), {}, {}, decisions};
    facts.forbidden.add(Effect::curtains);
    facts.cues[0] = {true, 8, 0};
    const effects::FramePlan plan = effects::plan_effects(effect_calls(facts), {});
    EXPECT_EQ(plan[Effect::vertical_lines].state, effects::PlanState::run);
    EXPECT_EQ(plan[Effect::projections].state, effects::PlanState::skipped);
    EXPECT_EQ(plan[Effect::curtains].state, effects::PlanState::skipped);
    EXPECT_NE(plan[Effect::curtains].reason, plan[Effect::projections].reason);
}

}  // namespace
}  // namespace tedavis::display::test_cue_calls
