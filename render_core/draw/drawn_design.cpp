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

DrawnDesign drawn_as(const design::DesignSettings& design, bool off_screen_depth, bool has_focus) noexcept {
    const GroundFocusKind focus = has_focus ? ground_focus_kind(design.foci) : GroundFocusKind();
    return {&design, output_of(design, off_screen_depth, focus), focus.foci > 0};
}

}  // namespace tedavis::draw
