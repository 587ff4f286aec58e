#include "render_core/draw/drawers/shadow_map.hpp"

namespace tedavis::draw {
namespace {

float number(double value) { return static_cast<float>(value); }

}  // namespace

base::Error ShadowMap::start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t level_px) {
    const gl::TextureSettings texels{gl::TextureFormat::rgba8, gl::TextureFilter::linear, level_px,
                                     level_px * static_cast<std::uint32_t>(kShadowLevels)};
    auto target = gl::make_render_target(gl, line, texels, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    level_px_ = level_px;
    return {};
}

void ShadowMap::begin_level(gl::Gl& gl, std::size_t level) const {
    const auto edge = static_cast<GLsizei>(level_px_);
    const auto first = static_cast<GLint>(level * level_px_);
    target_.bind(gl);
    gl->Viewport(0, first, edge, edge);
    gl->Scissor(0, first, edge, edge);
    gl->Enable(GL_SCISSOR_TEST);
    gl->ClearColor(0, 0, 0, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl->Enable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
}

void ShadowMap::end(gl::Gl& gl) const {
    gl->Disable(GL_SCISSOR_TEST);
    gl->Disable(GL_DEPTH_TEST);
}

void set_light_axes(gl::Gl& gl, GLint location, const ShadowFrame& frame, const glm::dvec3& origin) {
    const glm::dvec3 from = frame.in_light(origin);
    float rows[3][4];
    for (int n = 0; n < 3; ++n) {
        for (int axis = 0; axis < 3; ++axis) rows[n][axis] = number(frame.axes[n][axis]);
        rows[n][3] = number(from[n]);
    }
    gl->Uniform4fv(location, 3, rows[0]);
}

void set_shadow_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const ShadowRead& read,
                         const glm::dvec3& origin) {
    gl->Uniform1i(program.uniform(first), static_cast<GLint>(kShadowUnit));
    const bool is_there = read.map != nullptr && read.frame != nullptr;
    const ShadowFrame none;
    const ShadowFrame& frame = is_there ? *read.frame : none;
    set_light_axes(gl, program.uniform(first + 1), frame, origin);
    float levels[kShadowLevels][4];
    for (std::size_t n = 0; n < kShadowLevels; ++n) {
        const ShadowLevel& level = frame.levels[n];
        levels[n][0] = number(level.middle_m.x);
        levels[n][1] = number(level.middle_m.y);
        levels[n][2] = number(level.half_m);
        levels[n][3] = level.is_used ? 1.0f : 0.0f;
    }
    gl->Uniform4fv(program.uniform(first + 2), static_cast<GLsizei>(kShadowLevels), levels[0]);
    const double edge_px = is_there ? read.map->settings().width_px : 1;
    gl->Uniform4f(program.uniform(first + 3), is_there ? number(frame.on_ground) : 0.0f, number(kSunRadius_rad / frame.sine),
                  number(read.top_msl_m), number(edge_px));
    if (is_there) read.map->bind(gl, kShadowUnit);
}

}  // namespace tedavis::draw
