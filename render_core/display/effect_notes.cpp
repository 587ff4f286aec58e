#include "render_core/display/effect_notes.hpp"

#include <cmath>

#include <string_view>

namespace tedavis::display {
namespace {

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

void note(FrameRecord& record, std::string_view name, EffectState state, std::string_view reason,
          std::string_view replaced_by = {}) {
    EffectRecord effect;
    effect.name = Name(name);
    effect.state = state;
    effect.reason.append(reason);
    effect.replaced_by = Name(replaced_by);
    static_cast<void>(record.effects.try_push_back(effect));
}

constexpr EffectState run_or_skipped(bool runs) { return runs ? EffectState::run : EffectState::skipped; }

void note_silhouettes(const EffectInput& input, FrameRecord& record) {
    constexpr std::string_view kName = "silhouettes";
    const bool shown = input.decisions.show_terrain;
    if (input.silhouettes_replaced)
        note(record, kName, shown ? EffectState::replaced : EffectState::skipped, "the device has no 24-bit depth off screen",
             "ridges");
    else if (input.style.sketch.silhouettes > 0)
        note(record, kName, run_or_skipped(shown && input.has_silhouettes),
             input.has_silhouettes ? "asked for by the design" : "seen from so far away depths hardly differ");
}

void note_sun(const EffectInput& input, FrameRecord& record) {
    if (input.light == LightSource::fixed) return;
    const bool runs = input.light == LightSource::sun;
    const EffectState state = runs ? EffectState::run : EffectState::replaced;
    note(record, "moving_sun", input.decisions.show_terrain ? state : EffectState::skipped,
         runs                                      ? "asked for by the design"
         : input.light == LightSource::sun_too_low ? "the sun stands below 3 degrees"
                                                   : "the time of the flight is no date; name sun_utc in the design",
         runs ? "" : "fixed_light");
}

void note_drape(const EffectInput& input, FrameRecord& record) {
    if (input.drape == DrapeState::not_asked_for) return;
    const bool runs = input.drape == DrapeState::shown && input.decisions.show_terrain;
    note(record, "drape", run_or_skipped(runs),
         input.drape == DrapeState::not_in_database ? "the terrain database has no image; the plain colour is drawn"
         : input.drape == DrapeState::not_on_device ? "the device has no room for an image; the plain colour is drawn"
         : runs                                     ? "asked for by the design"
                                                    : "removed by the failure policy");
}

void add_technique(std::string_view name, Name& technique) {
    if (!technique.empty()) technique.append("+");
    technique.append(name);
}

void note_ground_data(const EffectInput& input, FrameRecord& record) {
    if (input.ground_data == GroundDataState::not_asked_for) return;
    const bool shown = input.ground_data == GroundDataState::shown, runs = shown && input.decisions.show_terrain;
    note(record, "ground_data", run_or_skipped(runs),
         shown && !runs ? "removed by the failure policy" : reason_of(input.ground_data));
    if (!runs || input.data == nullptr) return;
    const design::GroundData& ground = input.data->ground;
    record.data_aspect = {Name(ground.scale.breaks.empty() ? "ground_color" : "ground_color_classes"), detail_of(ground.scale),
                          1};
    const bool has_members = ground.members == design::GroundMembers::animated;
    Name technique(has_members ? "animated_members" : "");
    if (ground.uncertainty.technique != design::IntrinsicUncertainty::none)
        add_technique(design::kIntrinsicUncertaintyNames[static_cast<std::size_t>(ground.uncertainty.technique)], technique);
    if (ground.overlay.technique != design::UncertaintyOverlay::none)
        add_technique(design::kUncertaintyOverlayNames[static_cast<std::size_t>(ground.overlay.technique)], technique);
    if (technique.empty()) return;
    const double of_members = has_members ? design::detail_of_members(input.members) : 0;
    record.uncertainty_aspect = {technique,
                                 std::fmax(of_members, std::fmax(detail_of(ground.uncertainty), detail_of(ground.overlay))), 1};
}

std::string_view reason_of_maps(const EffectInput& input) {
    if (!input.decisions.show_terrain || input.decisions.unusual_attitude) return "removed by the failure policy";
    if (input.adjacent == GroundDataState::not_asked_for) return "a free view has no symbology";
    if (input.adjacent == GroundDataState::shown && input.adjacent_maps == 0)
        return "there is no room beside the symbology and the legends";
    return reason_of(input.adjacent);
}

void note_adjacent(const EffectInput& input, FrameRecord& record) {
    if (input.data == nullptr || !input.data->adjacent.is_shown) return;
    const bool runs = input.adjacent == GroundDataState::shown && input.adjacent_maps > 0;
    note(record, "adjacent", run_or_skipped(runs), reason_of_maps(input));
    const design::AdjacentShows shows = input.data->adjacent.shows;
    if (!runs || shows == design::AdjacentShows::value) return;
    const bool has_members = shows == design::AdjacentShows::members;
    AspectRecord& aspect = record.uncertainty_aspect;
    add_technique(has_members ? "adjacent_members" : "adjacent_map", aspect.technique);
    aspect.detail = std::fmax(
        aspect.detail, has_members ? design::detail_of_members(input.adjacent_maps) : detail_of(input.data->adjacent.scale));
    aspect.weight = 1;
}

void state_terrain_aspect(const EffectInput& input, AspectRecord& aspect) {
    design::TerrainStyle shown = input.style;
    if (input.drape == DrapeState::not_in_database || input.drape == DrapeState::not_on_device)
        shown.texture = design::TerrainTexture::plain;
    aspect.technique = input.decisions.show_terrain ? style_name(shown) : Name("none");
    aspect.detail = input.decisions.show_terrain ? 1 : 0;
    aspect.weight = 1;
}

}  // namespace

void note_effects(const EffectInput& input, FrameRecord& record) {
    const bool shown = input.decisions.show_terrain, warning = shown && input.decisions.show_warning_colors;
    note(record, "terrain", run_or_skipped(shown), shown ? "terrain in view" : "removed by the failure policy");
    note(record, "warning_colors", run_or_skipped(warning),
         warning ? "height is geometric and valid" : "not asked for or height not to be trusted");
    note_silhouettes(input, record);
    note_sun(input, record);
    note_drape(input, record);
    note_ground_data(input, record);
    note_adjacent(input, record);
    state_terrain_aspect(input, record.terrain_aspect);
}

}  // namespace tedavis::display
