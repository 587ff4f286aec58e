#include "render_core/display/scene_passes.hpp"

#include "render_core/gl/render_target.hpp"

namespace tedavis::display {
namespace {

void draw_terrain(gl::Gl& gl, const PassInput& input, const draw::DepthRange& range, draw::TerrainDrawResult& drawn) {
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_CULL_FACE);
    input.terrain.draw(gl, make_terrain_input(input.frame), range, drawn);
    gl->Disable(GL_CULL_FACE);
}

}  // namespace

gl::GlError ScenePasses::start(gl::Gl& gl, effects::DeviceSettings& device, const design::DesignSettings& design,
                               std::uint32_t width_px, std::uint32_t height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    output_ = draw::output_of(design.terrain.style, design.data, device.capability.depth24_targets);
    if (gl::GlError error = sky_.start(gl, device.budget); !error.sentence.empty()) return error;
    if (output_ == draw::TerrainOutput::color) return {};
    return picture_.start(gl, device.budget, width_px, height_px, design.terrain.style, output_);
}

draw::TerrainDrawResult ScenePasses::draw(gl::Gl& gl, const base::Surface& surface, const PassInput& input) {
    draw::TerrainDrawResult drawn;
    const bool shows_terrain = input.frame.decisions.show_terrain;
    const bool off_screen = shows_terrain && picture_.is_started();
    if (off_screen)
        picture_.begin(gl);
    else
        gl->Clear(GL_DEPTH_BUFFER_BIT);
    if (shows_terrain)
        draw_ranges(gl, input, drawn);
    else
        sky_.draw(gl, make_sky_input(input.frame));
    if (!off_screen) return drawn;
    picture_.finish(gl, surface, input.frame.design, picture_input(input));
    if (input.elements.has_anything()) draw_elements_over_picture(gl, input);
    return drawn;
}

/// Far terrain, the sky behind it, then near terrain with a depth of its own. The pass of an off-screen picture knows the sky.
void ScenePasses::draw_ranges(gl::Gl& gl, const PassInput& input, draw::TerrainDrawResult& drawn) {
    const draw::DepthPlan depth = input.terrain.depth_plan(input.frame.eye.view);
    for (std::size_t n = 0; n < depth.count; ++n) {
        if (n > 0) gl->Clear(GL_DEPTH_BUFFER_BIT);
        draw_terrain(gl, input, depth.ranges[n], drawn);
        gl->Disable(GL_DEPTH_TEST);
        if (picture_.is_started()) continue;
        if (n == 0) sky_.draw(gl, make_sky_input(input.frame));
        if (!input.elements.has_anything()) continue;
        gl->Enable(GL_DEPTH_TEST);
        input.elements.draw(gl, make_data_frame(input.frame), depth, n);
        gl->Disable(GL_DEPTH_TEST);
    }
    if (!picture_.is_started()) input.elements.draw_signs(gl, width_px_, height_px_);
}

/// Over a picture that was made off-screen, which has no depths: the terrain leaves its depths once more.
void ScenePasses::draw_elements_over_picture(gl::Gl& gl, const PassInput& input) {
    const draw::DepthPlan depth = input.terrain.depth_plan(input.frame.eye.view);
    draw::TerrainDrawResult depths_only;
    for (std::size_t n = 0; n < depth.count; ++n) {
        gl->Clear(GL_DEPTH_BUFFER_BIT);
        gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        draw_terrain(gl, input, depth.ranges[n], depths_only);
        gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        if (n > 0) picture_.repaint(gl, input.frame.design, picture_input(input));
        input.elements.draw(gl, make_data_frame(input.frame), depth, n);
        gl->Disable(GL_DEPTH_TEST);
    }
    input.elements.draw_signs(gl, width_px_, height_px_);
}

draw::PictureInput ScenePasses::picture_input(const PassInput& input) {
    draw::PictureInput picture = make_picture_input(input.frame);
    picture.outlined = input.plan.runs(effects::Effect::silhouettes);
    picture.ground = input.terrain.drawn_part(input.frame.eye.view);
    picture.has_void = input.has_void;
    return picture;
}

void ScenePasses::destroy(gl::Gl& gl) {
    sky_.destroy(gl);
    picture_.destroy(gl);
}

}  // namespace tedavis::display
