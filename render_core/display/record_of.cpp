#include "render_core/display/record_of.hpp"

#include "render_core/display/planner/effect_notes.hpp"
#include "render_core/display/planner/frame_notes.hpp"

namespace tedavis::display {
namespace {

ClutterRecord clutter_of(const PlannedFrame& plan) {
    ClutterRecord record;
    record.budget = plan.shown->priority.held_clutter();
    if (record.budget >= 1) return record;
    record.measured = plan.clutter.measured;
    record.reached = plan.clutter.reached;
    record.left = plan.declutter.regions;
    record.roles = plan.clutter.roles;
    return record;
}

}  // namespace

FrameRecord record_of(const PlannedFrame& plan, const DrawnFrame& drawn, const ElementReports& reports,
                      const base::BudgetTable& table) {
    FrameRecord record;
    static_cast<FrameStatement&>(record) = plan;
    for (std::size_t n = 0; n < policy::kElementCount; ++n) record.elements[n] = plan.decisions.elements[n].show;
    if (drawn.ground_data_is_missing) flag(policy::RecordFlag::ground_data_missing, record);
    record_effects({plan.effects, plan.decisions, *plan.shown, plan.data.members, plan.maps_beside.drawn}, record);
    record_budget(plan.budget, record);
    record_elements(reports, record);
    record.clutter = clutter_of(plan);
    record_weights(plan.shown->priority, plan.weights, record);
    record_drawn(drawn.terrain, table, record);
    record_work(drawn.work, record);
    record.bytes.uploaded = drawn.uploaded_bytes;
    return record;
}

}  // namespace tedavis::display
