#include "render_core/display/planner/frame_notes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::display::test_frame_notes {
namespace {

bool has_flag(const FrameRecord& record, std::string_view name) {
    for (const Name& flag : record.flags)
        if (flag.view() == name) return true;
    return false;
}

/// A layer of a role, of which nothing else is asked.
struct LayerOf {
    explicit LayerOf(scene::LayerRole role) {
        entry.role = role;
        layer.entry = &entry;
        attribute.entry = &attribute_entry;
        layer.attributes = {&attribute, 1};
    }
    [[nodiscard]] ElementReport report(draw::ElementCount count, ElementState state = ElementState::shown) const {
        return {state, &element, &layer, count};
    }

    design::DataElement element;
    scene::LayerEntry entry{};
    scene::AttributeEntry attribute_entry{};
    scene::Attribute attribute;
    scene::Layer layer;
};

TEST(FrameNotes, AFlagIsRaisedOnce) {
    FrameRecord record;
    flag("a", record);
    flag("b", record);
    flag("a", record);
    EXPECT_EQ(record.flags.size(), 2u);
}

TEST(FrameNotes, TheRendererIsNamedAndWhyItIsNotTheOneAskedFor) {
    using design::TerrainRenderer;
    FrameRecord traced, drawn, instead;
    record_renderer(TerrainRenderer::trace, draw::TraceState::traced, {}, traced);
    record_renderer(TerrainRenderer::raster, draw::TraceState::not_asked_for, {}, drawn);
    record_renderer(TerrainRenderer::trace, draw::TraceState::database_too_large, {}, instead);
    EXPECT_EQ(traced.terrain.renderer.view(), "trace");
    EXPECT_EQ(drawn.terrain.renderer.view(), "raster");
    EXPECT_EQ(instead.terrain.renderer.view(), "raster");
    for (const FrameRecord* record : {&traced, &drawn}) {
        EXPECT_TRUE(record->terrain.renderer_reason.empty());
        EXPECT_FALSE(has_flag(*record, "terrain.not_traced"));
    }
    EXPECT_TRUE(has_flag(instead, "terrain.not_traced"));
    for (int state = 0; state <= static_cast<int>(draw::TraceState::not_by_cost); ++state) {
        FrameRecord record;
        record_renderer(TerrainRenderer::trace, static_cast<draw::TraceState>(state), {}, record);
        EXPECT_FALSE(record.terrain.renderer_reason.cut()) << "whole: " << state;
    }
}

/// The choice is no stand-in: nothing is missing of what the design asks for.
TEST(FrameNotes, AChosenRendererIsNamedWithItsReasonAndBothCosts) {
    using design::TerrainRenderer;
    const effects::RendererDecision decision{false, effects::RendererWhy::costs_no_more, {true, 7, 9, 1, 0}};
    FrameRecord chosen, polar;
    record_renderer(TerrainRenderer::automatic, draw::TraceState::not_by_cost, decision, chosen);
    EXPECT_EQ(chosen.terrain.renderer.view(), "raster");
    EXPECT_EQ(chosen.terrain.renderer_reason.view(), "it costs no more than the other renderer");
    EXPECT_EQ(chosen.terrain.triangles_ms, 7);
    EXPECT_EQ(chosen.terrain.rays_ms, 9);
    EXPECT_TRUE(chosen.flags.empty());
    record_renderer(TerrainRenderer::automatic, draw::TraceState::place_too_polar, {}, polar);
    EXPECT_EQ(polar.terrain.renderer_reason.view(), "the eye is too close to a pole");
    EXPECT_EQ(polar.terrain.rays_ms, 0) << "there was no choice";
    for (std::size_t why = 0; why < static_cast<std::size_t>(effects::RendererWhy::count_); ++why) {
        FrameRecord record;
        record_renderer(TerrainRenderer::automatic, draw::TraceState::traced, {true, static_cast<effects::RendererWhy>(why), {}},
                        record);
        EXPECT_EQ(record.terrain.renderer.view(), "trace");
        EXPECT_FALSE(record.terrain.renderer_reason.cut()) << "whole: " << why;
    }
}

TEST(FrameNotes, TheTerrainSaysWhatKeptItFromTau) {
    FrameRecord record;
    record.terrain.tau_px = 1;
    TerrainPlan plan;
    plan.lod.tau_reached_px = 1;
    plan.lod.worst_chunk = {2, 30, 4};
    plan.has_void = true;
    record_terrain(plan, record);
    EXPECT_EQ(record.terrain.worst_chunk.view(), "2/30/4");
    EXPECT_TRUE(has_flag(record, "terrain.void"));
    EXPECT_FALSE(has_flag(record, "terrain.tau_raised"));
    plan.lod.tau_reached_px = 1.5;
    plan.is_late = plan.is_failing = true;
    FrameRecord other;
    other.terrain.tau_px = 1;
    record_terrain(plan, other);
    for (const char* name : {"terrain.tau_raised", "terrain.late", "terrain.failing"}) EXPECT_TRUE(has_flag(other, name)) << name;
}

TEST(FrameNotes, AMissedDeadlineIsFlagged) {
    effects::BudgetReport report{33, 40, 5, true, false, effects::GovernorWhy::too_dear, {2.5, 0.5, {}, 0, 0, 0}};
    report.quality.given_up.add(effects::Effect::antialiasing);
    FrameRecord record;
    record_budget(report, record);
    EXPECT_EQ(record.governor.deadline_ms, 33);
    EXPECT_EQ(record.governor.predicted_ms, 40);
    EXPECT_EQ(record.governor.quality_level, 5u);
    EXPECT_TRUE(record.governor.changed);
    EXPECT_EQ(record.governor.tau_factor, 2.5);
    EXPECT_EQ(record.governor.detail_factor, 0.5);
    EXPECT_TRUE(record.governor.given_up.has(effects::Effect::antialiasing));
    EXPECT_EQ(record.governor.why.view(), "the time does not suffice");
    EXPECT_FALSE(has_flag(record, "deadline.missed"));
    report.is_missed = true;
    record_budget(report, record);
    EXPECT_TRUE(has_flag(record, "deadline.missed"));
}

TEST(FrameNotes, ThinnedGlyphsShowLessDetail) {
    LayerOf wind(scene::LayerRole::wind);
    ElementReport report = wind.report({3, 0, 0});
    report.detail_factor = 0.5;
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(report));
    FrameRecord record;
    record_elements(reports, record);
    EXPECT_EQ(record.data_aspect.detail, 0.5);
}

TEST(FrameNotes, FeaturesAreCountedByTheirType) {
    const LayerOf obstacles(scene::LayerRole::obstacle), storm(scene::LayerRole::storm_cell);
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(obstacles.report({5, 2, 1})));
    ASSERT_TRUE(reports.try_push_back(storm.report({1, 0, 0})));
    ASSERT_TRUE(reports.try_push_back(obstacles.report({10, 0, 0})));
    FrameRecord record;
    record_elements(reports, record);
    ASSERT_EQ(record.data.size(), 2u);
    EXPECT_EQ(record.data[0].type.view(), "obstacle");
    EXPECT_EQ(record.data[0].drawn, 15u);
    EXPECT_EQ(record.data[0].aggregated, 2u);
    EXPECT_EQ(record.data[0].hidden, 1u);
    EXPECT_FALSE(has_flag(record, "data.missing"));
}

TEST(FrameNotes, WhatIsNotShownIsHiddenAndFlagged) {
    const LayerOf areas(scene::LayerRole::no_go);
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(areas.report({4, 3, 2}, ElementState::out_of_date)));
    FrameRecord record;
    record_elements(reports, record);
    ASSERT_EQ(record.data.size(), 1u);
    EXPECT_EQ(record.data[0].drawn + record.data[0].aggregated, 0u);
    EXPECT_EQ(record.data[0].hidden, 9u);
    EXPECT_TRUE(has_flag(record, "data.missing"));
}

TEST(FrameNotes, EveryElementIsAnEffectWithItsReason) {
    LayerOf storm(scene::LayerRole::storm_cell), tracks(scene::LayerRole::trajectory);
    storm.element.technique = design::DataTechnique::prism;
    storm.element.role = scene::LayerRole::storm_cell;
    storm.element.detail = 0.5;
    tracks.element.technique = design::DataTechnique::tube;
    tracks.element.layer = "tracks";
    tracks.element.detail = 0.25;
    tracks.element.uncertainty = design::ElementUncertainty::widening;
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(storm.report({1, 0, 0})));
    ASSERT_TRUE(reports.try_push_back(tracks.report({1, 0, 0}, ElementState::wrong_layer)));
    FrameRecord record;
    record_elements(reports, record);
    ASSERT_EQ(record.effects.size(), 2u);
    EXPECT_EQ(record.effects[0].name.view(), "data.prism");
    EXPECT_EQ(record.effects[0].state, EffectState::run);
    EXPECT_EQ(record.effects[0].reason.view(), "storm_cell: asked for by the design");
    EXPECT_EQ(record.effects[1].state, EffectState::skipped);
    EXPECT_EQ(record.effects[1].reason.view(), "tracks: the technique does not show layers of this kind");
    EXPECT_EQ(record.data_aspect.technique.view(), "prism");
    EXPECT_EQ(record.data_aspect.detail, 0.5);
    EXPECT_TRUE(record.uncertainty_aspect.technique.empty()) << "what is not shown says nothing";
}

/// Each with as much detail as the others, as in re-planning.
TEST(FrameNotes, EveryTechniqueThatShowsAnAspectIsNamedOnce) {
    LayerOf storm(scene::LayerRole::storm_cell), tracks(scene::LayerRole::trajectory), masts(scene::LayerRole::obstacle);
    for (LayerOf* const layer : {&storm, &tracks}) {
        layer->attribute_entry.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
        layer->attribute_entry.uncertainty_all = scene::Uncertainty::from_level(0.5);
    }
    storm.element.technique = tracks.element.technique = design::DataTechnique::prism;
    storm.element.uncertainty = design::ElementUncertainty::transparency;
    tracks.element.uncertainty = masts.element.uncertainty = design::ElementUncertainty::widening;
    tracks.element.uncertainty_levels = 2;
    ElementReports reports;
    ASSERT_TRUE(reports.try_push_back(tracks.report({1, 0, 0})));
    ASSERT_TRUE(reports.try_push_back(masts.report({3, 0, 0})));
    ASSERT_TRUE(reports.try_push_back(storm.report({0, 0, 4})));
    FrameRecord record;
    record_elements(reports, record);
    EXPECT_EQ(record.uncertainty_aspect.technique.view(), "widening") << "no storm is drawn";
    EXPECT_EQ(record.uncertainty_aspect.detail, 0.25) << "two gradations of sixteen";
    reports[2] = storm.report({0, 4, 0});
    record = {};
    record_elements(reports, record);
    EXPECT_EQ(record.data_aspect.technique.view(), "prism+solid");
    EXPECT_EQ(record.uncertainty_aspect.technique.view(), "widening+transparency");
    EXPECT_EQ(record.uncertainty_aspect.detail, 1);
    tracks.attribute_entry.uncertainty_all = scene::Uncertainty();
    storm.attribute_entry.uncertainty_kind = scene::UncertaintyKind::none;
    record = {};
    record_elements(reports, record);
    EXPECT_TRUE(record.uncertainty_aspect.technique.empty()) << "control: none of the layers states an uncertainty";
}

TEST(FrameNotes, DrawsAndBytesAreThoseOfTheFrame) {
    FrameRecord record;
    EffectRecord terrain;
    terrain.name = Name("terrain");
    ASSERT_TRUE(record.effects.try_push_back(terrain));
    draw::TerrainDrawResult drawn;
    drawn.triangles = 900;
    drawn.draws = 7;
    base::BudgetTable budget;
    base::BudgetLine line;
    line.name = "a";
    line.bytes = 100;
    line.use.take(40);
    ASSERT_TRUE(budget.try_add(line));
    record_drawn(drawn, budget, record);
    EXPECT_EQ(record.terrain.triangles, 900u);
    EXPECT_EQ(record.effects[0].draws, 7u);
    EXPECT_EQ(record.bytes.cpu, 40u);
    EXPECT_EQ(record.bytes.cpu_budget, 100u);
}

TEST(FrameNotes, WorkIsThatOfEachEffect) {
    FrameRecord record;
    for (const char* name : {"terrain", "haze", "antialiasing", "data.tube"}) {
        EffectRecord effect;
        effect.name = Name(name);
        effect.draws = 3;
        ASSERT_TRUE(record.effects.try_push_back(effect));
    }
    EffectWorkTable work;
    work[effects::Effect::antialiasing] += {1, 2, 4};
    work[effects::Effect::antialiasing] += {1, 0, 4};
    record_work(work, record);
    EXPECT_EQ(record.effects[0].draws, 3u) << "record_drawn says it";
    EXPECT_EQ(record.effects[1].draws, 0u);
    EXPECT_EQ(record.effects[2].draws, 2u);
    EXPECT_EQ(record.effects[2].passes, 2u);
    EXPECT_EQ(record.effects[2].bytes, 8u);
    EXPECT_EQ(record.effects[3].draws, 3u);
}

TEST(FrameNotes, WhatIsOutOfViewIsNotDrawn) {
    const LayerOf areas(scene::LayerRole::no_go), ways(scene::LayerRole::trajectory);
    ElementReports reports;
    ElementReport area = areas.report({4, 0, 2}), way = ways.report({10, 30, 0});
    area.out_of_view = 3;
    way.out_of_view = 25;
    ASSERT_TRUE(reports.try_push_back(area));
    ASSERT_TRUE(reports.try_push_back(way));
    FrameRecord record;
    record_elements(reports, record);
    EXPECT_EQ(record.data[0].drawn, 1u);
    EXPECT_EQ(record.data[0].hidden, 2u);
    EXPECT_EQ(record.data[0].out_of_view, 3u);
    EXPECT_EQ(record.data[1].drawn, 0u);
    EXPECT_EQ(record.data[1].aggregated, 15u);
    EXPECT_EQ(record.data[1].out_of_view, 25u);
}

}  // namespace
}  // namespace tedavis::display::test_frame_notes
