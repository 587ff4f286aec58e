/// What a frame's record says of the terrain, the data and the memory. Pure; any thread.
#pragma once

#include <string_view>

#include "render_core/display/planner/effect_work.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/display/planner/frame_record.hpp"
#include "render_core/display/planner/terrain_planner.hpp"
#include "render_core/draw/terrain_draw_result.hpp"
#include "render_core/effects/frame_budget.hpp"
#include "render_core/policy/flag_table.hpp"

namespace tedavis::display {

/// Once, however often it is raised. A full list counts what it refuses.
void flag(std::string_view name, FrameStatement& record);
void flag(policy::RecordFlag raised, FrameStatement& record);

/// Once a layer, with the flag data.stale; an age of 0 is none.
void record_stale(std::string_view layer, base::Duration age, FrameStatement& record);

/// One more technique that shows an aspect, named once; the aspect's detail is that of the most detailed one.
void add_technique(std::string_view name, double detail, AspectRecord& aspect);

/// Asks for record.terrain.tau_px. Triangles are those planned until record_drawn().
void record_terrain(const TerrainPlan& plan, FrameStatement& record);
/// With the flag terrain.not_traced where rays were asked for and triangles are drawn.
void record_renderer(design::TerrainRenderer asked, draw::TraceState state, FrameStatement& record);
/// Counts by type, an effect an element ("data.tube"), and the techniques of all that is shown of the data and of their
/// uncertainty.
void record_elements(const ElementReports& reports, FrameRecord& record);
/// The weight of each aspect, and of which one something has raised it.
void record_weights(const design::PrioritySettings& priority, const design::AspectWeights& weights, FrameRecord& record);
/// With the flag deadline.missed where it was missed.
void record_budget(const effects::BudgetReport& report, FrameRecord& record);
/// After record_effects().
void record_work(const EffectWorkTable& work, FrameRecord& record);
/// After the terrain is noted among the effects.
void record_drawn(const draw::TerrainDrawResult& drawn, const base::BudgetTable& budget, FrameRecord& record);

}  // namespace tedavis::display
