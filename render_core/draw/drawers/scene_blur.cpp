#include "render_core/draw/drawers/scene_blur.hpp"

#include <cstdio>

#include "render_core/draw/drawers/pass_targets.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum BlurUniform : std::size_t { kPicture, kFocus, kTaps, kBlurUniforms };

struct BlurShader {
    const char *name, *picture;
    std::string_view body;
};

base::Result<gl::Program, base::Error> build_blur(gl::Gl& gl, const BlurShader& shader, std::uint32_t square_px) {
    const char* const names[kBlurUniforms] = {shader.picture, "focus", "taps"};
    base::FixedString<kMaxShaderText> fragment(square_definition(square_px).view());
    fragment.append(shader_text(k_blur_radius_frag));
    fragment.append(shader.body);
    return gl::build_program(
        gl, {shader.name, shader_text(k_screen_vert), fragment.view(), base::Span<const gl::AttributeBinding>(kScreenAttributes),
             base::Span<const char* const>(names), true});
}

}  // namespace

base::FixedString<31> square_definition(std::uint32_t square_px) {
    char line[32];
    std::snprintf(line, sizeof line, "#define TEXEL %u\n", static_cast<unsigned>(square_px));
    return base::FixedString<31>(line);
}

void set_focus_uniform(gl::Gl& gl, std::int32_t uniform, const FocusRange& focus) {
    gl->Uniform3f(uniform, static_cast<float>(focus.near_m), static_cast<float>(focus.far_m), static_cast<float>(focus.blur_px));
}

base::Error SceneBlur::build_programs(gl::Gl& gl) {
    auto reducing = build_blur(gl, {"blur source", "scene", shader_text(k_blur_source_frag)}, square_px_);
    if (!reducing.ok()) return reducing.error();
    reducing_ = reducing.value();
    auto gathering = build_blur(gl, {"blur", "squares", shader_text(k_blur_gather_frag)}, square_px_);
    if (!gathering.ok()) return gathering.error();
    gathering_ = gathering.value();
    return {};
}

base::Error SceneBlur::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                             std::uint32_t square_px) {
    square_px_ = square_px;
    const std::uint32_t width = (width_px + square_px - 1) / square_px, height = (height_px + square_px - 1) / square_px;
    PassTargets targets(gl, *budget.find(effects::kRenderTargets));
    targets.make(squares_, width, height);
    targets.make(surroundings_, width, height);
    if (targets.error()) return targets.error();
    return build_programs(gl);
}

void SceneBlur::draw(gl::Gl& gl, const ScreenGrid& grid, const gl::Texture& scene, const FocusRange& focus) {
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    squares_.bind(gl);
    scene.bind(gl, 0);
    reducing_.use(gl);
    gl->Uniform1i(reducing_.uniform(kPicture), 0);
    set_focus_uniform(gl, reducing_.uniform(kFocus), focus);
    grid.draw(gl);
    surroundings_.bind(gl);
    squares_.color().bind(gl, 0);
    gathering_.use(gl);
    gl->Uniform1i(gathering_.uniform(kPicture), 0);
    set_focus_uniform(gl, gathering_.uniform(kFocus), focus);
    gl->Uniform1i(gathering_.uniform(kTaps), static_cast<GLint>(focus.taps));
    grid.draw(gl);
}

void SceneBlur::bind(gl::Gl& gl, std::uint32_t first_unit) const {
    squares_.color().bind(gl, first_unit);
    surroundings_.color().bind(gl, first_unit + 1);
}

void SceneBlur::destroy(gl::Gl& gl) {
    reducing_.destroy(gl);
    gathering_.destroy(gl);
    surroundings_.destroy(gl);
    squares_.destroy(gl);
}

}  // namespace tedavis::draw
