#include "render_core/display/scene_passes.hpp"

#include "render_core/draw/view_frame.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::display {
namespace {

void draw_terrain(gl::Gl& gl, const PassInput& input, const draw::DepthRange& range, draw::TerrainDrawResult& drawn) {
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_CULL_FACE);
    input.terrain.draw(gl, input.seen, make_terrain_input(input.frame), range, drawn);
    gl->Disable(GL_CULL_FACE);
}

void draw_terrain_depths(gl::Gl& gl, const PassInput& input, const draw::DepthRange& range) {
    draw::TerrainDrawResult not_counted;
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_CULL_FACE);
    input.terrain.draw_depths(gl, input.seen, make_terrain_input(input.frame), range, not_counted);
    gl->Disable(GL_CULL_FACE);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

bool smooths(const design::ViewEffects& effects) { return effects.antialiasing == design::Antialiasing::on; }

/// Sharp as shaders/focus.frag writes it.
draw::FocusRange context_range(const design::DesignSettings& design) {
    const double sharp_m = draw::sharp_distance_m();
    return {true, sharp_m, sharp_m, terrain_of_context(design.foci).blur_px};
}

draw::DataFrame data_frame(const PassInput& input) {
    draw::DataFrame frame = make_data_frame(input.frame);
    frame.grid = {&input.frame.design.terrain.style.grid, input.seen.database};
    frame.without_uncertainty = input.frame.last < PictureLayer::uncertainty;
    return frame;
}

bool draws_elements(const PassInput& input) { return input.frame.last >= PictureLayer::data && input.data.shown != 0; }

/// Whatever must not be blurred writes a distance that is in focus.
void leave_distances(DrawContext& frame) {
    const design::DepthOfField& field = frame.design.effects.depth_of_field;
    const double sharp = draw::distance_code(0.5 * (frame.focus.near_m + frame.focus.far_m));
    const draw::DistanceLeft all{0, 1}, in_focus{sharp, sharp};
    frame.terrain_left = field.on_terrain ? all : in_focus;
    frame.data_left = field.on_data ? all : in_focus;
}

}  // namespace

base::Error ScenePasses::start(gl::Gl& gl, effects::DeviceSettings& device, draw::DrawnDesigns designs, std::uint32_t width_px,
                               std::uint32_t height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    has_air_ = designs[0].design->sky.air.is_shown;
    base::BudgetLine& targets = *device.budget.find(effects::kRenderTargets);
    if (base::Error error = sky_.start(gl, device.budget, has_air_)) return error;
    if (has_air_)
        if (base::Error error = air_.start(gl, targets)) return error;
    bool has_shadows = false, goes_off_screen = false;
    for (const draw::DrawnDesign& drawn : designs) {
        has_shadows = has_shadows || drawn.design->effects.shadows.is_any();
        goes_off_screen = goes_off_screen || draw::goes_off_screen(drawn);
    }
    if (has_shadows)
        if (base::Error error = shadows_.start(gl, targets, device.capability.shadow_map_px)) return error;
    if (base::Error error = start_view_effects(gl, device, designs)) return error;
    goes_off_screen_ = draw::goes_off_screen(designs[0]);
    is_deferred_ = designs[0].is_deferred;
    return goes_off_screen ? picture_.start(gl, device.budget, width_px, height_px, designs) : base::Error{};
}

/// What at least one of the designs requests.
base::Error ScenePasses::start_view_effects(gl::Gl& gl, effects::DeviceSettings& device, draw::DrawnDesigns designs) {
    bool has_shafts = false;
    for (const draw::DrawnDesign& drawn : designs) {
        const design::ViewEffects& effects = drawn.design->effects;
        smooths_ = smooths_ || smooths(effects);
        blurs_ = blurs_ || effects.depth_of_field.blur_px > 0 || draw::blurs_context(drawn);
        has_shafts = has_shafts || effects.shadows.in_air > 0;
    }
    if (has_shafts)
        if (base::Error error = shafts_.start(gl, device.budget, width_px_, height_px_, has_air_)) return error;
    if (!smooths_ && !blurs_ && !has_shafts) return {};
    return view_effects_.start(gl, device.budget, width_px_, height_px_,
                               {smooths_, blurs_, has_shafts, device.capability.blur_square_px}, has_air_);
}

bool ScenePasses::shows(const draw::DrawnDesign& design) const {
    const design::ViewEffects& effects = design.design->effects;
    const bool blurs = effects.depth_of_field.blur_px > 0 || draw::blurs_context(design);
    return (smooths_ || !smooths(effects)) && (blurs_ || !blurs) && (shadows_.is_started() || !effects.shadows.is_any()) &&
           (shafts_.is_started() || effects.shadows.in_air <= 0) && design.design->sky.air.is_shown == has_air_ &&
           (!draw::goes_off_screen(design) || picture_.shows(design));
}

void ScenePasses::set_design(const draw::DrawnDesign& design) {
    goes_off_screen_ = draw::goes_off_screen(design);
    is_deferred_ = design.is_deferred;
    if (goes_off_screen_) picture_.set_design(design);
}

/// The first light of the style stands for the sun.
draw::AirFrame ScenePasses::update_air(gl::Gl& gl, const PassInput& input) {
    if (!input.plan.runs(effects::Effect::aerial_perspective)) return {};
    const DrawContext& frame = input.frame;
    const policy::TerrainLight& light = frame.record.light;
    const WorkScope work(gl, input.work[effects::Effect::aerial_perspective], 0);
    air_.update(gl, frame.design.sky.air, frame.eye_msl_m, light.elevation_rad);
    draw::AirFrame air = air_.frame();
    air.towards_sun = policy::towards_light(light.azimuth_rad, light.elevation_rad, frame.record.own_ship.position);
    air.up = earth::up_at(frame.camera.view.eye);
    air.dip_rad = draw::horizon_dip_rad(frame.eye_msl_m);
    air.eye_height_m = frame.eye_msl_m;
    air.share = 1 - frame.map_share;
    return air;
}

/// One map serves all that reads it.
draw::ShadowRead ScenePasses::draw_shadows(gl::Gl& gl, const PassInput& input) {
    const bool is_read = input.plan.runs(effects::Effect::soft_shadows) || input.plan.runs(effects::Effect::volumetric_light);
    if (!is_read || !shadows_.is_started() || input.frame.shadows.state != effects::ShadowState::cast) return {};
    const ShadowPlan& plan = input.frame.shadows;
    EffectWork map;
    if (!input.has_shadow_map) {
        const WorkScope work(gl, map);
        static_cast<void>(
            shadows_.draw(gl, input.elements.caster_drawers(), input.casters, plan.frame, input.frame.camera.view.eye));
    }
    for (const effects::Effect reader : {effects::Effect::soft_shadows, effects::Effect::volumetric_light})
        if (input.plan.runs(reader)) input.work[reader] += map;
    return {&shadows_.map().texture(), &plan.frame, plan.top_msl_m};
}

draw::TerrainDrawResult ScenePasses::draw(gl::Gl& gl, const gl::DrawPlace& place, const PassInput& input) {
    DrawContext frame = input.frame;
    frame.air = update_air(gl, input);
    const draw::ShadowRead shadow = draw_shadows(gl, input);
    if (input.plan.runs(effects::Effect::soft_shadows)) frame.shadow_read = shadow;
    const bool has_shafts = shadow.map != nullptr && input.plan.runs(effects::Effect::volumetric_light) && shafts_.is_started();
    draw::ViewEffectsInput effects;
    effects.blurs = input.plan.runs(effects::Effect::depth_of_field);
    effects.smooths = input.plan.runs(effects::Effect::antialiasing);
    effects.focus = frame.focus;
    if (has_shafts) frame.terrain_left = frame.data_left = {0, 1};
    if (effects.blurs) leave_distances(frame);
    frame.blurs_context = input.plan.runs(effects::Effect::focus_blur) && frame.foci != nullptr;
    if (frame.blurs_context) {
        effects.blurs = true;
        effects.focus = context_range(frame.design);
        const double sharp = draw::distance_code(draw::sharp_distance_m());
        frame.terrain_left = {0, 1};
        frame.data_left = {sharp, sharp};
    }
    const bool has_effects = effects.blurs || effects.smooths || has_shafts;
    draw::TerrainDrawResult drawn;
    const PassInput drawing{frame,         input.plan, input.terrain,  input.seen,           input.elements,   input.data,
                            input.casters, input.work, input.has_void, input.has_shadow_map, input.has_terrain};
    draw_scene(gl, has_effects ? gl::DrawPlace(view_effects_.target()) : place, drawing, drawn);
    if (has_shafts) {
        draw_shafts(gl, drawing, shadow);
        effects.shafts = &shafts_.texture();
    }
    if (has_effects) finish_effects(gl, place, effects, frame.blurs_context, input.work);
    if (frame.decisions.show_terrain && frame.last >= PictureLayer::labels)
        input.elements.draw_signs(gl, input.data, width_px_, height_px_);
    return drawn;
}

/// One pass for all: each has it among its work.
void ScenePasses::finish_effects(gl::Gl& gl, const gl::DrawPlace& place, const draw::ViewEffectsInput& asked, bool is_of_context,
                                 EffectWorkTable& work) {
    EffectWork pass;
    {
        const WorkScope scope(gl, pass);
        view_effects_.finish(gl, place, asked);
    }
    if (asked.blurs) work[is_of_context ? effects::Effect::focus_blur : effects::Effect::depth_of_field] += pass;
    if (asked.smooths) work[effects::Effect::antialiasing] += pass;
    if (asked.shafts != nullptr) work[effects::Effect::volumetric_light] += pass;
}

void ScenePasses::draw_shafts(gl::Gl& gl, const PassInput& input, const draw::ShadowRead& shadow) {
    const DrawContext& frame = input.frame;
    const WorkScope work(gl, input.work[effects::Effect::volumetric_light]);
    shafts_.draw(gl, {frame.camera.view, view_effects_.target().color(), shadow, frame.air, frame.haze_per_m,
                      frame.design.sky.haze, frame.shadows.in_air, frame.shadows.steps});
}

void ScenePasses::draw_scene(gl::Gl& gl, const gl::DrawPlace& place, const PassInput& input, draw::TerrainDrawResult& drawn) {
    place.bind(gl);
    const bool shows_terrain = input.frame.decisions.show_terrain;
    if (!shows_terrain || !goes_off_screen_) {
        gl->Clear(GL_DEPTH_BUFFER_BIT);
        if (shows_terrain)
            draw_ranges(gl, input, drawn);
        else
            sky_.draw(gl, make_sky_input(input.frame));
        return;
    }
    if (!input.has_terrain) draw_off_screen(gl, input);
    drawn = off_screen_;
    const draw::PictureInput picture = picture_input(input);
    EffectWork unlined;
    {
        const WorkScope work(gl, picture.outlined ? input.work[effects::Effect::silhouettes] : unlined);
        picture_.finish(gl, place, input.frame.design, picture);
    }
    if (draws_elements(input)) draw_elements_over_picture(gl, input);
}

void ScenePasses::draw_off_screen(gl::Gl& gl, const PassInput& input) {
    off_screen_ = {};
    if (input.seen.is_traced && is_deferred_) {
        picture_.begin(gl);
        input.terrain.draw_shaded(gl, input.seen, make_terrain_input(input.frame));
    } else if (input.seen.is_traced) {
        gl->Clear(GL_DEPTH_BUFFER_BIT);
        input.terrain.draw_traced(gl, input.seen, make_terrain_input(input.frame), picture_.scene());
    } else {
        picture_.begin(gl);
        draw_ranges(gl, input, off_screen_);
    }
}

/// Far terrain, the sky behind it, then near terrain with a depth of its own. The pass of an off-screen picture knows the sky.
void ScenePasses::draw_ranges(gl::Gl& gl, const PassInput& input, draw::TerrainDrawResult& drawn) {
    const draw::DepthPlan& depth = input.seen.depth;
    for (std::size_t n = 0; n < depth.count; ++n) {
        if (n > 0) gl->Clear(GL_DEPTH_BUFFER_BIT);
        draw_terrain(gl, input, depth.ranges[n], drawn);
        gl->Disable(GL_DEPTH_TEST);
        if (goes_off_screen_) continue;
        if (n == 0) sky_.draw(gl, make_sky_input(input.frame));
        if (!draws_elements(input)) continue;
        gl->Enable(GL_DEPTH_TEST);
        input.elements.draw(gl, input.data, data_frame(input), depth, n);
        gl->Disable(GL_DEPTH_TEST);
    }
}

/// Over a picture that was made off-screen, which has no depths: the terrain leaves its depths once more. Near triangles leave
/// none in the far range, so that the picture is painted again over what they hide; traced ground leaves them in both.
void ScenePasses::draw_elements_over_picture(gl::Gl& gl, const PassInput& input) {
    const draw::DepthPlan& depth = input.seen.depth;
    for (std::size_t n = 0; n < depth.count; ++n) {
        gl->Clear(GL_DEPTH_BUFFER_BIT);
        draw_terrain_depths(gl, input, depth.ranges[n]);
        if (n > 0 && !input.seen.is_traced) picture_.repaint(gl, input.frame.design, picture_input(input));
        input.elements.draw(gl, input.data, data_frame(input), depth, n);
        gl->Disable(GL_DEPTH_TEST);
    }
}

draw::PictureInput ScenePasses::picture_input(const PassInput& input) {
    draw::PictureInput picture = make_picture_input(input.frame);
    picture.outlined = input.plan.runs(effects::Effect::silhouettes);
    picture.ground = input.seen.part;
    picture.has_void = input.has_void;
    return picture;
}

void ScenePasses::destroy(gl::Gl& gl) {
    sky_.destroy(gl);
    air_.destroy(gl);
    shadows_.destroy(gl);
    view_effects_.destroy(gl);
    shafts_.destroy(gl);
    picture_.destroy(gl);
}

}  // namespace tedavis::display
