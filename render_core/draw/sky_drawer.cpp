#include "render_core/draw/sky_drawer.hpp"

#include <cmath>

#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

constexpr float kCorners[] = {-1, -1, 3, -1, -1, 3};
constexpr gl::AttributeBinding kAttributes[] = {{"position", 0}};
enum Uniform : std::size_t { kHalfTangent, kDownOfAxes, kSineOfDip, kPixelsPerDown, kZenith, kHorizon, kGroundHorizon, kGround };
constexpr const char* kUniforms[] = {"half_tangent", "down_of_axes",  "sine_of_dip",          "pixels_per_down",
                                     "zenith_color", "horizon_color", "ground_horizon_color", "ground_color"};
constexpr double kFlattestHorizon = 1e-3;  // straight up or down the horizon has no direction on the screen

void set_color(gl::Gl& gl, GLint location, design::Color color) {
    gl->Uniform3f(location, static_cast<float>(color.red) / 255.0f, static_cast<float>(color.green) / 255.0f,
                  static_cast<float>(color.blue) / 255.0f);
}

}  // namespace

gl::GlError SkyDrawer::start(gl::Gl& gl, base::BudgetTable& budget) {
    auto corners = gl::make_buffer(gl, *budget.find(effects::kSymbologyVertices), gl::BufferKind::vertices, gl::BufferUse::fixed,
                                   sizeof kCorners);
    if (!corners.ok()) return corners.error();
    corners_ = static_cast<gl::Buffer&&>(corners.value());
    if (!corners_.upload(gl, 0, kCorners, sizeof kCorners)) return gl::make_error("the sky's corners cannot be uploaded");
    auto program =
        gl::build_program(gl, {"sky", shader_text(k_sky_vert), shader_text(k_sky_frag),
                               base::Span<const gl::AttributeBinding>(kAttributes), base::Span<const char* const>(kUniforms)});
    if (!program.ok()) return program.error();
    program_ = static_cast<gl::Program&&>(program.value());
    return {};
}

void SkyDrawer::draw(gl::Gl& gl, const SkyInput& input) const {
    const ViewFrame& view = input.view;
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LEQUAL);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    program_.use(gl);
    gl->Uniform2f(program_.uniform(kHalfTangent), static_cast<float>(view.center_x / view.focal_px),
                  static_cast<float>(view.center_y / view.focal_px));
    gl->Uniform3f(program_.uniform(kDownOfAxes), static_cast<float>(view.body_axes[0].z), static_cast<float>(view.body_axes[1].z),
                  static_cast<float>(view.body_axes[2].z));
    gl->Uniform1f(program_.uniform(kSineOfDip), static_cast<float>(std::sin(input.dip_rad)));
    const double slope = std::fmax(std::hypot(view.body_axes[1].z, view.body_axes[2].z), kFlattestHorizon);
    gl->Uniform1f(program_.uniform(kPixelsPerDown), static_cast<float>(view.focal_px / slope));
    set_color(gl, program_.uniform(kZenith), input.colors.zenith);
    set_color(gl, program_.uniform(kHorizon), input.colors.horizon);
    set_color(gl, program_.uniform(kGroundHorizon), input.colors.ground_horizon);
    set_color(gl, program_.uniform(kGround), input.colors.ground);
    corners_.bind(gl);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->DisableVertexAttribArray(0);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

void SkyDrawer::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    corners_.destroy(gl);
}

}  // namespace tedavis::draw
