#include "render_core/effects/effect_table.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/effects/design_effects.hpp"
#include "render_core/effects/effect_conditions.hpp"
#include "render_core/effects/effect_row_builder.hpp"

namespace tedavis::effects {
namespace {

using Design = design::DesignSettings;
using Kind = EffectRequest::Kind;
using Row = EffectRowBuilder;

template <double design::ElementCues::*Cue>
bool asks_for_cue(const Design& design) {
    const design::DataElementList& elements = design.data.elements;
    return std::any_of(elements.begin(), elements.end(),
                       [](const design::DataElement& element) { return element.cues.*Cue > 0; });
}

template <double design::ElementCues::*Cue>
void take_out_cue(Design& design) {
    for (design::DataElement& element : design.data.elements) element.cues.*Cue = 0;
}

/// Ways that would cast shadows are projected onto the ground instead, as strongly at least.
void project_casters(const design::CasterRoles& casters, double strength, design::DataElementList& elements) {
    if (!(strength > 0)) return;
    for (design::DataElement& element : elements) {
        const bool is_way =
            element.technique == design::DataTechnique::tube || element.technique == design::DataTechnique::space_time;
        if (is_way && casters.has(element.role)) element.cues.projection = std::fmax(element.cues.projection, strength);
    }
}

void replace_silhouettes(const Design& asked, Effect by, Design& possible) {
    design::SketchSettings& sketch = possible.terrain.style.sketch;
    if (by == Effect::ridges) sketch.ridges = std::fmax(sketch.ridges, asked.terrain.style.sketch.silhouettes);
    if (by != Effect::silhouettes) sketch.silhouettes = 0;
}

void replace_soft_shadows(const Design& asked, Effect by, Design& possible) {
    const design::ShadowSettings& shadows = asked.effects.shadows;
    if (by == Effect::projections) project_casters(shadows.casters, shadows.on_ground, possible.data.elements);
    if (by != Effect::soft_shadows) possible.effects.shadows.on_ground = 0;
}

void replace_volumetric_light(const Design& asked, Effect by, Design& possible) {
    const design::ShadowSettings& shadows = asked.effects.shadows;
    double& on_ground = possible.effects.shadows.on_ground;
    if (by == Effect::projections) project_casters(shadows.casters, shadows.in_air, possible.data.elements);
    if (by == Effect::soft_shadows) on_ground = std::fmax(on_ground, shadows.in_air);
    if (by != Effect::volumetric_light) possible.effects.shadows.in_air = 0;
}

/// Blur is another effect.
bool asks_for_context(const Design& design) {
    design::FocusTerrain context = terrain_of_context(design.foci);
    context.blur_px = 0;
    bool asks = context.is_any();
    for (const design::FocusSettings& focus : design.foci) asks = asks || focus.border.kind != design::FocusBorderKind::none;
    return asks;
}

void take_out_context(Design& design) {
    for (design::FocusSettings& focus : design.foci) {
        const double blur_px = focus.terrain.blur_px;
        focus.terrain = {};
        focus.terrain.blur_px = blur_px;
        focus.border = {};
    }
}

void take_out_context_blur(Design& design) {
    for (design::FocusSettings& focus : design.foci) focus.terrain.blur_px = 0;
}

/// Alpha of the picture has room for distances, or for how sharp it is.
void replace_context_blur(const Design&, Effect by, Design& possible) {
    if (by == Effect::focus_blur && !reads_distances(possible)) return;
    for (design::FocusSettings& focus : possible.foci) {
        if (by != Effect::count_) focus.terrain = design::darkened_instead_of_blurred(focus.terrain);
        focus.terrain.blur_px = 0;
    }
}

void take_out_grid(Design& design) {
    design.terrain.style.grid.spacing_m = design.terrain.style.grid.spacing_rad = 0;
    for (design::DataElement& element : design.data.elements) element.grid = false;
}

void take_out_image(Design& design) {
    design::TerrainTexture& texture = design.terrain.style.texture;
    if (texture == design::TerrainTexture::image) texture = design::TerrainTexture::plain;
}

constexpr std::array<EffectRow, kEffectCount> kTable{{
    Row(Effect::terrain, "terrain")
        .costs("the terrain pass")
        .asked_by("", [](const Design&) { return true; })
        .applies([](const EffectFacts&) {
            return EffectRequest{Kind::applicable, "terrain in view"};
        }),
    Row(Effect::warning_colors, "warning_colors")
        .costs("a variant of the terrain's program")
        .asked_by("[warning] enabled", [](const Design&) { return true; })
        .on_taking_out([](Design& design) { design.warning_colors = false; })
        .applies([](const EffectFacts& facts) -> EffectRequest {
            if (facts.shows_warning_colors) return {Kind::applicable, "height is geometric and valid"};
            return {Kind::not_applicable, "not asked for or height not to be trusted"};
        }),
    Row(Effect::silhouettes, "silhouettes")
        .needs(Need::depth24_target)
        .may_be_forbidden()
        .costs("a picture off screen, and a pass of five taps")
        .replaced_by(Effect::ridges)
        .may_be_given_up()
        .asked_by("[terrain.sketch] silhouettes",
                  [](const Design& design) { return design.terrain.style.sketch.silhouettes > 0; })
        .on_taking_out([](Design& design) { design.terrain.style.sketch.silhouettes = 0; })
        .on_replacing(replace_silhouettes)
        .applies([](const EffectFacts& facts) -> EffectRequest {
            if (facts.is_near) return kApplicable;
            return {Kind::not_applicable, "seen from so far away depths hardly differ"};
        }),
    Row(Effect::ridges, "ridges").costs("a variant of the terrain's program").on_taking_out([](Design& design) {
        design.terrain.style.sketch.ridges = 0;
    }),
    Row(Effect::moving_sun, "moving_sun")
        .may_be_forbidden()
        .costs("shadows anew at every quarter of a degree")
        .replaced_by(Effect::fixed_light)
        .asked_by("[terrain.shade] follows_sun", [](const Design& design) { return design.terrain.style.shade.follows_sun; })
        .on_taking_out([](Design& design) { design.terrain.style.shade.follows_sun = false; })
        .applies(sun_request),
    Row(Effect::fixed_light, "fixed_light").costs("none"),
    Row(Effect::drape, "drape")
        .may_be_forbidden()
        .costs("pages of the image, and a tap")
        .replaced_by(Effect::plain_color)
        .asked_by("[terrain.texture] technique",
                  [](const Design& design) { return design.terrain.style.texture == design::TerrainTexture::image; })
        .on_taking_out(take_out_image)
        .applies([](const EffectFacts& facts) { return where(facts.image); }),
    Row(Effect::plain_color, "plain_color").costs("none"),
    Row(Effect::aerial_perspective, "aerial_perspective")
        .needs(Need::half_float_texture)
        .may_be_forbidden()
        .changes(Contribution::color, "1 - what is left of the strongest band over the farthest ground, at the densest air")
        .costs("three taps and a root a pixel; a table of 64 x 64 a step of the eye's height")
        .replaced_by(Effect::haze)
        .asked_by("[sky] aerial_perspective", [](const Design& design) { return design.sky.air.is_shown; })
        .on_asking([](Design& design) { design.sky.air.is_shown = true; })
        .on_taking_out([](Design& design) { design.sky.air.is_shown = false; })
        .applies([](const EffectFacts& facts) {
            return facts.is_near ? EffectRequest{Kind::applicable, "", facts.air_bound} : kFromFarAway;
        }),
    Row(Effect::haze, "haze")
        .may_be_forbidden()
        .changes(Contribution::color, "1 - exp(-farthest ground / haze distance)")
        .costs("an exponential a vertex, and a blend a pixel")
        .asked_by("[sky] haze_distance_m",
                  [](const Design& design) { return !design.sky.air.is_shown && design.sky.haze_distance_m > 0; })
        .on_taking_out([](Design& design) { design.sky.haze_distance_m = 0; })
        .applies([](const EffectFacts& facts) {
            return facts.has_haze ? EffectRequest{Kind::applicable, "", facts.haze_bound} : kFromFarAway;
        }),
    Row(Effect::surface_grid, "surface_grid")
        .may_be_forbidden()
        .costs(
            "two lines' distances, a pixel of the ground; three, and a place's latitude, longitude and height, a pixel of data")
        .asked_by("[terrain.grid] spacing_m", [](const Design& design) { return design.terrain.style.grid.is_shown(); })
        .on_taking_out(take_out_grid)
        .applies(always),
    Row(Effect::ground_data, "ground_data")
        .may_be_forbidden()
        .costs("taps of the slice and of its colours, a pixel of the ground")
        .asked_by("[data.ground] enabled", [](const Design& design) { return design.data.ground.is_shown; })
        .on_taking_out([](Design& design) { design.data.ground.is_shown = false; })
        .applies([](const EffectFacts& facts) { return where(facts.ground_data); }),
    Row(Effect::adjacent, "adjacent")
        .may_be_forbidden()
        .distracts()
        .costs("quads of the symbology")
        .asked_by("[data.adjacent] enabled", [](const Design& design) { return design.data.adjacent.is_shown; })
        .on_taking_out([](Design& design) { design.data.adjacent.is_shown = false; })
        .applies(beside_request),
    Row(Effect::depth_of_field, "depth_of_field")
        .needs(Need::second_picture)
        .may_be_forbidden()
        .distracts()
        .changes(Contribution::geometry, "the widest blur between the nearest ground and the farthest")
        .costs("a picture off screen; in squares of pixels, four taps and seventeen; and a pass of nine taps")
        .may_be_given_up()
        .asked_by("[effects.depth_of_field] blur_px",
                  [](const Design& design) { return design.effects.depth_of_field.blur_px > 0; })
        .on_asking([](Design& design) { design.effects.depth_of_field.blur_px = 4; })
        .on_taking_out([](Design& design) { design.effects.depth_of_field.blur_px = 0; })
        .applies(focus_request),
    Row(Effect::antialiasing, "antialiasing")
        .needs(Need::second_picture)
        .may_be_forbidden()
        .changes(Contribution::geometry, "one pixel, where anything has an edge")
        .costs("a picture off screen, and a pass of five taps; four more at edges")
        .may_be_given_up()
        .asked_by("[effects] antialiasing",
                  [](const Design& design) { return design.effects.antialiasing == design::Antialiasing::on; })
        .on_asking([](Design& design) { design.effects.antialiasing = design::Antialiasing::on; })
        .on_taking_out([](Design& design) { design.effects.antialiasing = design::Antialiasing::off; })
        .applies([](const EffectFacts&) {
            return EffectRequest{Kind::applicable, "", 1};
        }),
    Row(Effect::panel_lighting, "panel_lighting")
        .may_be_forbidden()
        .without_terrain()
        .changes(Contribution::color, "1 - the darkest factor")
        .costs("a blended pass over the display")
        .asked_by("[effects] lighting",
                  [](const Design& design) { return design.effects.lighting != design::PanelLighting::day; })
        .on_asking([](Design& design) { design.effects.lighting = design::PanelLighting::night; })
        .on_taking_out([](Design& design) { design.effects.lighting = design::PanelLighting::day; })
        .applies(panel_request),
    Row(Effect::stereo, "stereo")
        .needs(Need::second_picture)
        .may_be_forbidden()
        .distracts()
        .changes(Contribution::geometry, "the greatest parallax between the nearest ground and the farthest")
        .costs("the scene twice, into a picture off screen, and a tap")
        .asked_by("[effects.stereo] mode",
                  [](const Design& design) { return design.effects.stereo.mode != design::StereoMode::none; })
        .on_asking([](Design& design) { design.effects.stereo.mode = design::StereoMode::side_by_side; })
        .on_taking_out([](Design& design) { design.effects.stereo.mode = design::StereoMode::none; })
        .applies([](const EffectFacts& facts) {
            return facts.is_near ? EffectRequest{Kind::applicable, "", facts.parallax_px} : kFromFarAway;
        }),
    Row(Effect::cross_fade, "cross_fade")
        .needs(Need::second_picture)
        .may_be_forbidden()
        .distracts()
        .changes(Contribution::color, "the share of the scene as it was")
        .costs("the scene as it was, once, into a picture off screen; then a blended tap")
        .asked_by("[effects] fade_s", [](const Design& design) { return design.effects.fade_s > 0; })
        .on_asking([](Design& design) { design.effects.fade_s = 0.5; })
        .on_taking_out([](Design& design) { design.effects.fade_s = 0; })
        .applies([](const EffectFacts& facts) -> EffectRequest {
            if (facts.fade_share > 0) return {Kind::applicable, "", facts.fade_share};
            return {Kind::not_applicable, "nothing has changed"};
        }),
    Row(Effect::vertical_lines, "vertical_lines")
        .may_be_forbidden()
        .costs("twelve triangles a line; those that travel are built every frame")
        .asked_by("[data.element.cues] line_spacing_m", asks_for_cue<&design::ElementCues::line_spacing_m>)
        .on_taking_out(take_out_cue<&design::ElementCues::line_spacing_m>)
        .applies([](const EffectFacts& facts) {
            return cue_request(facts.vertical_lines, facts.forbidden.has(Effect::vertical_lines));
        }),
    Row(Effect::projections, "projections")
        .may_be_forbidden()
        .costs("two triangles a stretch of 200 m")
        .asked_by("[data.element.cues] projection", asks_for_cue<&design::ElementCues::projection>)
        .on_taking_out(take_out_cue<&design::ElementCues::projection>)
        .applies(
            [](const EffectFacts& facts) { return cue_request(facts.projections, facts.forbidden.has(Effect::projections)); }),
    Row(Effect::curtains, "curtains")
        .may_be_forbidden()
        .costs("two triangles a stretch of 200 m, blended on both sides")
        .asked_by("[data.element.cues] curtain", asks_for_cue<&design::ElementCues::curtain>)
        .on_taking_out(take_out_cue<&design::ElementCues::curtain>)
        .applies([](const EffectFacts& facts) { return cue_request(facts.curtains, facts.forbidden.has(Effect::curtains)); }),
    Row(Effect::soft_shadows, "soft_shadows")
        .needs(Need::shadow_map)
        .may_be_forbidden()
        .distracts()
        .changes(Contribution::geometry, "the widest thing that casts one, in pixels over the nearest ground")
        .costs("a map of up to three levels; 10 taps a pixel of the ground, 32 more in a shadow")
        .replaced_by(Effect::projections)
        .may_be_given_up()
        .asked_by("[effects.shadows] on_ground", [](const Design& design) { return design.effects.shadows.on_ground > 0; })
        .on_asking([](Design& design) { design.effects.shadows.on_ground = 0.6; })
        .on_taking_out([](Design& design) { design.effects.shadows.on_ground = 0; })
        .on_replacing(replace_soft_shadows)
        .applies(soft_shadow_request),
    Row(Effect::volumetric_light, "volumetric_light")
        .needs(Need::shadow_map_and_picture)
        .may_be_forbidden()
        .distracts()
        .changes(Contribution::color, "its strength times that of air, or of haze")
        .costs("the same map; a pass of a tap a step at half the picture's size, and one of four taps")
        .replaced_by(Effect::soft_shadows, Effect::projections)
        .may_be_given_up()
        .asked_by("[effects.shadows] in_air", [](const Design& design) { return design.effects.shadows.in_air > 0; })
        .on_asking([](Design& design) { design.effects.shadows.in_air = 0.6; })
        .on_taking_out([](Design& design) { design.effects.shadows.in_air = 0; })
        .on_replacing(replace_volumetric_light)
        .applies(light_shaft_request),
    Row(Effect::focus_ground, "focus_ground")
        .may_be_forbidden()
        .distracts()
        .costs("a variant of the terrain's program; six taps and two for each point that is near, a pixel of ground at a rim or "
               "between")
        .asked_by("[focus.terrain], [focus.border]", asks_for_context)
        .on_taking_out(take_out_context)
        .applies(context_request),
    Row(Effect::focus_blur, "focus_blur")
        .needs(Need::second_picture)
        .may_be_forbidden()
        .distracts()
        .changes(Contribution::geometry, "the blur of the context")
        .costs("a picture off screen; in squares of pixels, four taps and seventeen; and a pass of nine taps")
        .replaced_by(Effect::focus_ground)
        .may_be_given_up()
        .asked_by("[focus.terrain] blur_px", [](const Design& design) { return terrain_of_context(design.foci).blur_px > 0; })
        .on_taking_out(take_out_context_blur)
        .on_replacing(replace_context_blur)
        .applies(context_blur_request),
    Row(Effect::saliency, "saliency")
        .needs(Need::picture_copy)
        .may_be_forbidden()
        .distracts()
        .costs("a copy of the picture, and some eighty passes at a quarter of its size, an eighth on ES 2; a blended tap")
        .may_be_given_up()
        .asked_by("[effects.saliency] view",
                  [](const Design& design) { return design.effects.saliency.view != design::SaliencyView::none; })
        .on_asking([](Design& design) { design.effects.saliency.view = design::SaliencyView::heat; })
        .on_taking_out([](Design& design) { design.effects.saliency = {}; })
        .applies(always),
    Row(Effect::clutter, "clutter")
        .may_be_forbidden()
        .distracts()
        .costs("for a budget, twice a second (once on ES 2): the scene up to six times, each read back and searched for edges by "
               "the processor; as a view: every picture read back and searched, a byte a pixel uploaded, and a tap")
        .asked_by("[priority] clutter_budget, [effects.clutter] view",
                  [](const Design& design) {
                      return design.priority.held_clutter() < 1 || design.effects.clutter != design::ClutterView::none;
                  })
        .on_asking([](Design& design) { design.effects.clutter = design::ClutterView::regions; })
        .on_taking_out([](Design& design) {
            design.effects.clutter = design::ClutterView::none;
            design.priority.clutter_budget = 1;
        })
        .applies(clutter_request),
}};

constexpr bool is_in_order() {
    for (std::size_t n = 0; n < kEffectCount; ++n)
        if (kTable[n].effect != static_cast<Effect>(n)) return false;
    return true;
}
static_assert(is_in_order());

}  // namespace

const EffectRow& row_of(Effect effect) noexcept { return kTable[static_cast<std::size_t>(effect)]; }

Effect effect_of(std::string_view name) noexcept {
    for (const EffectRow& row : kTable)
        if (row.name == name) return row.effect;
    return Effect::count_;
}

}  // namespace tedavis::effects
