/// What a frame's record says of its effects: which ran, which were replaced or skipped, and why; and of the aspects they show.
///
/// Pure. Thread  any. Memory  none. Failure  a full list counts what it refuses.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/display/frame_record.hpp"
#include "render_core/effects/effect_planner.hpp"
#include "render_core/policy/display_decisions.hpp"

namespace tedavis::display {

struct EffectNotes {
    const effects::FramePlan& plan;
    const policy::DisplayDecisions& decisions;
    const design::DesignSettings& design;  ///< as drawn
    std::uint32_t members = 0;             ///< of the ground's ensemble, that are shown one after the other
    std::uint32_t adjacent_maps = 0;       ///< that are drawn
};

/// Appends to the record's effects and states its aspects.
void record_effects(const EffectNotes& notes, FrameRecord& record);

}  // namespace tedavis::display
