#include "render_core/display/effect_notes.hpp"

#include <string_view>

#include "render_core/display/frame_notes.hpp"

namespace tedavis::display {
namespace {

using effects::Effect;

/// "hypsometric_lambert", with "_sketch" where lines are drawn.
Name style_name(const design::TerrainStyle& style) {
    Name name(design::kTerrainTextureNames[static_cast<std::size_t>(style.texture)]);
    if (style.shade.technique != design::TerrainShade::none) {
        name.append("_");
        name.append(design::kTerrainShadeNames[static_cast<std::size_t>(style.shade.technique)]);
    }
    if (design::has_lines(style.sketch)) name.append("_sketch");
    return name;
}

EffectState state_of(effects::PlanState state) {
    return state == effects::PlanState::run        ? EffectState::run
           : state == effects::PlanState::replaced ? EffectState::replaced
                                                   : EffectState::skipped;
}

void note(Effect effect, const effects::PlannedEffect& planned, FrameRecord& record) {
    if (planned.state == effects::PlanState::not_asked_for) return;
    EffectRecord noted;
    noted.name = Name(effects::row_of(effect).name);
    noted.state = state_of(planned.state);
    noted.reason.append(planned.reason);
    if (planned.replaced_by != Effect::count_) noted.replaced_by = Name(effects::row_of(planned.replaced_by).name);
    noted.bound = planned.bound;
    static_cast<void>(record.effects.try_push_back(noted));
}

void state_data_aspects(const design::GroundData& ground, std::uint32_t members, FrameRecord& record) {
    const bool has_classes = ground.scale.palette.is_nominal() || !ground.scale.breaks.empty();
    add_technique(has_classes ? "ground_color_classes" : "ground_color", detail_of(ground.scale), record.data_aspect);
    const bool has_members = ground.members == design::GroundMembers::animated;
    AspectRecord& uncertainty = record.uncertainty_aspect;
    if (has_members) add_technique("animated_members", design::detail_of_members(members), uncertainty);
    if (ground.uncertainty.technique != design::IntrinsicUncertainty::none)
        add_technique(design::kIntrinsicUncertaintyNames[static_cast<std::size_t>(ground.uncertainty.technique)],
                      detail_of(ground.uncertainty), uncertainty);
    if (ground.overlay.technique != design::UncertaintyOverlay::none)
        add_technique(design::kUncertaintyOverlayNames[static_cast<std::size_t>(ground.overlay.technique)],
                      detail_of(ground.overlay), uncertainty);
}

void add_adjacent_aspect(const design::AdjacentView& adjacent, std::uint32_t maps, AspectRecord& aspect) {
    if (adjacent.shows == design::AdjacentShows::value) return;
    const bool has_members = adjacent.shows == design::AdjacentShows::members;
    if (has_members)
        add_technique("adjacent_members", design::detail_of_members(maps), aspect);
    else
        add_technique("adjacent_map", detail_of(adjacent.scale), aspect);
}

void state_terrain_aspect(const EffectNotes& notes, AspectRecord& aspect) {
    design::TerrainStyle shown = notes.design.terrain.style;
    if (notes.plan.runs(Effect::plain_color)) shown.texture = design::TerrainTexture::plain;
    aspect.technique = notes.decisions.show_terrain ? style_name(shown).view() : std::string_view("none");
    aspect.detail = notes.decisions.show_terrain ? detail_of(shown) : 0;
}

}  // namespace

void record_effects(const EffectNotes& notes, FrameRecord& record) {
    for (std::size_t n = 0; n < effects::kEffectCount; ++n)
        note(static_cast<Effect>(n), notes.plan[static_cast<Effect>(n)], record);
    if (notes.plan.runs(Effect::ground_data)) state_data_aspects(notes.design.data.ground, notes.members, record);
    if (notes.plan.runs(Effect::adjacent))
        add_adjacent_aspect(notes.design.data.adjacent, notes.adjacent_maps, record.uncertainty_aspect);
    state_terrain_aspect(notes, record.terrain_aspect);
}

}  // namespace tedavis::display
