/// What a frame's record says of its effects: which ran, which were replaced or skipped, and why.
///
/// Pure. Thread  any. Memory  none. Failure  a full list counts what it refuses.
#pragma once

#include "render_core/design/terrain_style.hpp"
#include "render_core/display/display_decisions.hpp"
#include "render_core/display/frame_record.hpp"
#include "render_core/display/spatial_data.hpp"
#include "render_core/display/terrain_scene.hpp"

namespace tedavis::display {

struct EffectInput {
    const DisplayDecisions& decisions;
    const design::TerrainStyle& style;  ///< as drawn: silhouettes are 0 where the device had them replaced
    bool silhouettes_replaced = false;
    bool has_silhouettes = false;  ///< the view lets something hide something else
    LightSource light = LightSource::fixed;
    DrapeState drape = DrapeState::not_asked_for;
    GroundDataState ground_data = GroundDataState::not_asked_for;
    const design::DataStyle* data = nullptr;  ///< null: none is asked for
    std::uint32_t members = 0;                ///< of the ground's ensemble, that are shown one after the other
    GroundDataState adjacent = GroundDataState::not_asked_for;
    std::uint32_t adjacent_maps = 0;  ///< that are drawn; 0 where they have no room
};

/// Appends to the record's effects and states its aspects.
void note_effects(const EffectInput& input, FrameRecord& record);

}  // namespace tedavis::display
