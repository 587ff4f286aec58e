#include "render_core/draw/drawn_design.hpp"

namespace tedavis::draw {

bool has_shafts_only(const design::DesignSettings& design) noexcept {
    return design.effects.shadows.in_air > 0 && design.terrain.style.sketch.silhouettes <= 0 &&
           design.effects.depth_of_field.blur_px <= 0;
}

bool blurs_context(const DrawnDesign& design) noexcept {
    return design.has_focus && ground_focus_kind(design.design->foci).blurs;
}

bool goes_off_screen(const DrawnDesign& design) noexcept {
    const bool serves_effects =
        design.output == TerrainOutput::color_and_distance && (has_shafts_only(*design.design) || blurs_context(design));
    return design.output != TerrainOutput::color && !serves_effects;
}

bool has_air_in_picture(const DrawnDesign& design) noexcept { return design.design->sky.air.is_shown && goes_off_screen(design); }

TerrainOutput output_of(const design::DesignSettings& design, bool off_screen_depth, const GroundFocusKind& focus) noexcept {
    if (focus.blurs) return TerrainOutput::color_and_distance;
    if (!off_screen_depth) return TerrainOutput::color;
    const design::TerrainStyle& style = design.terrain.style;
    // Codes tell distances too coarsely for the colours of air, and know of no second light beside their own, and no borders.
    const bool has_more = design.effects.shadows.is_any() || design::magnifies(design) || focus.foci > 0;
    if (design::fits_pixel_code(style) && !design.data.ground.is_shown && !design.sky.air.is_shown && !has_more)
        return TerrainOutput::code;
    const design::ViewEffects& effects = design.effects;
    const bool needs_distance = style.sketch.silhouettes > 0 || effects.depth_of_field.blur_px > 0 ||
                                effects.shadows.in_air > 0 || design.sky.air.is_shown;
    return needs_distance ? TerrainOutput::color_and_distance : TerrainOutput::color;
}

DrawAbility ability_of(const effects::DeviceSettings& device) noexcept {
    const effects::DeviceCapability& capability = device.capability;
    DrawAbility ability{capability.depth24_targets, capability.lane == effects::Lane::es3, false};
    const base::BudgetLine* const pictures = device.budget.find(effects::kTracedPictures);
    const std::uint64_t pixels = std::uint64_t{device.width_px} * device.height_px;
    const bool has_room = pictures != nullptr && pictures->bytes >= kShadedTexelBytes * pixels;
    ability.shades_rays = ability.is_es3 && ability.off_screen_depth && has_room && capability.off_screen_pictures > 0 &&
                          device.max_chunk_slots <= kMaxGeometrySlots && capability.gl.max_texture_units > kGeometryUnit;
    return ability;
}

DrawnDesign drawn_as(const design::DesignSettings& design, const DrawAbility& ability, bool has_focus) noexcept {
    const GroundFocusKind focus = has_focus ? ground_focus_kind(design.foci) : GroundFocusKind();
    DrawnDesign drawn{&design, output_of(design, ability.off_screen_depth, focus), focus.foci > 0, false, ability.is_es3};
    const bool is_shaded = design::may_trace(design.terrain) && ability.shades_rays &&
                           design.view.reference != design::Reference::flat && !design::magnifies(design);
    if (is_shaded && drawn.output == TerrainOutput::color) drawn.output = TerrainOutput::color_and_distance;
    drawn.is_deferred = is_shaded && drawn.output == TerrainOutput::color_and_distance && goes_off_screen(drawn);
    return drawn;
}

}  // namespace tedavis::draw
