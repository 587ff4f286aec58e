#include "render_core/draw/drawers/sky_drawer.hpp"

#include <cmath>

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/shader_texts.hpp"

namespace tedavis::draw {
namespace {

constexpr double kFlattestHorizon = 1e-3;  // straight up or down the horizon has no direction on the screen

void set_sky_color(gl::Gl& gl, GLint location, design::Color color) {
    gl->Uniform3f(location, static_cast<float>(color.red) / 255.0f, static_cast<float>(color.green) / 255.0f,
                  static_cast<float>(color.blue) / 255.0f);
}

}  // namespace

const char* const kSkyUniformNames[kSkyUniforms] = {
    "half_tangent",      "down_of_axes",         "sine_of_dip",       "pixels_per_down",  "zenith_color",
    "horizon_color",     "ground_horizon_color", "ground_color",      "ground_hatch",     "air_horizon",
    kAirUniformNames[0], kAirUniformNames[1],    kAirUniformNames[2], kAirUniformNames[3]};

void set_sky_uniforms(gl::Gl& gl, const gl::Program& program, const SkyInput& input) {
    const ViewFrame& view = input.view;
    const auto at = [&](SkyUniform uniform) { return program.uniform(uniform); };
    gl->Uniform2f(at(kHalfTangent), static_cast<float>(view.center_x / view.focal_px),
                  static_cast<float>(view.center_y / view.focal_px));
    gl->Uniform3f(at(kDownOfAxes), static_cast<float>(view.body_axes[0].z), static_cast<float>(view.body_axes[1].z),
                  static_cast<float>(view.body_axes[2].z));
    gl->Uniform1f(at(kSineOfDip), static_cast<float>(std::sin(input.dip_rad)));
    const double slope = std::fmax(std::hypot(view.body_axes[1].z, view.body_axes[2].z), kFlattestHorizon);
    gl->Uniform1f(at(kPixelsPerDown), static_cast<float>(view.focal_px / slope));
    set_sky_color(gl, at(kZenith), input.colors.zenith);
    set_sky_color(gl, at(kHorizon), input.colors.horizon);
    set_sky_color(gl, at(kGroundHorizon), input.colors.ground_horizon);
    set_sky_color(gl, at(kGround), input.colors.ground);
    gl->Uniform1f(at(kGroundHatch), input.ground_is_unknown ? 1.0f : 0.0f);
    if (at(kAirHorizon) >= 0) {
        const glm::vec3 light[2] = {glm::vec3(input.air.horizon_molecules), glm::vec3(input.air.horizon_aerosol)};
        gl->Uniform3fv(at(kAirHorizon), 2, &light[0].x);
    }
    if (at(kSkyAir) >= 0) set_air_uniforms(gl, program, kSkyAir, input.air, input.axes);
}

base::Error SkyDrawer::start(gl::Gl& gl, base::BudgetTable& budget, bool with_air) {
    if (base::Error error = grid_.start(gl, budget)) return error;
    base::FixedString<kMaxShaderText> fragment(with_air ? "#define AIR 1\n" : "");
    if (with_air) fragment.append(shader_text(k_air_frag));
    fragment.append(shader_text(k_unknown_ground_frag));
    fragment.append(shader_text(k_sky_color_frag));
    fragment.append(shader_text(k_sky_frag));
    auto program = gl::build_program(
        gl, {"sky", shader_text(k_screen_vert), fragment.view(), base::Span<const gl::AttributeBinding>(kScreenAttributes),
             base::Span<const char* const>(kSkyUniformNames), true});
    if (!program.ok()) return program.error();
    program_ = static_cast<gl::Program&&>(program.value());
    return {};
}

void SkyDrawer::draw(gl::Gl& gl, const SkyInput& input) const {
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LEQUAL);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    program_.use(gl);
    set_sky_uniforms(gl, program_, input);
    grid_.draw(gl);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

void SkyDrawer::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    grid_.destroy(gl);
}

}  // namespace tedavis::draw
