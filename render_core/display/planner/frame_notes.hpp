/// Writes what a frame's record says of the terrain, the data and the memory. Pure; any thread.
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

/// Raises a flag. A flag that is raised again is listed once. A full list counts what it refuses.
void flag(std::string_view name, FrameStatement& record);
void flag(policy::RecordFlag raised, FrameStatement& record);

/// Records a stale layer, each once, and raises the flag data.stale. With an age of 0 it does nothing.
void record_stale(std::string_view layer, base::Duration age, FrameStatement& record);

/// Adds a technique that shows an aspect. It is named once; the aspect's detail is that of its most detailed technique.
void add_technique(std::string_view name, double detail, AspectRecord& aspect);

/// Records the terrain's plan; record.terrain.tau_px must be set. The number of triangles is the planned one until
/// record_drawn().
void record_terrain(const TerrainPlan& plan, FrameStatement& record);
/// Records what draws the terrain, and raises the flag terrain.not_traced where rays were requested and triangles are drawn.
/// `decision` counts where the design leaves the choice to the display.
void record_renderer(design::TerrainRenderer asked, draw::TraceState state, const effects::RendererDecision& decision,
                     FrameStatement& record);
/// Records counts by type, an effect for each element ("data.tube"), and the techniques that show the data and their uncertainty.
void record_elements(const ElementReports& reports, FrameRecord& record);
/// Records the weight of each aspect, and which weights were raised.
void record_weights(const design::PrioritySettings& priority, const design::AspectWeights& weights, FrameRecord& record);
/// Records how the deadline was held, and raises the flag deadline.missed where it was missed.
void record_budget(const effects::BudgetReport& report, FrameRecord& record);
/// Records the GL work of the effects; to be called after record_effects().
void record_work(const EffectWorkTable& work, FrameRecord& record);
/// Records what was drawn; to be called after the terrain has been recorded among the effects.
void record_drawn(const draw::TerrainDrawResult& drawn, const base::BudgetTable& budget, FrameRecord& record);

}  // namespace tedavis::display
