#include "render_core/draw/drawers/light_shafts.hpp"

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum ShaftUniform : std::size_t {
    kShaftScene = kShadowUniforms,
    kShaftRays,
    kShaftBox,
    kShaftLook,
    kShaftHaze,
    kShaftAir,
    kShaftUniforms = kShaftAir + kAirUniforms
};
constexpr const char* kNames[kShaftUniforms] = {kShadowUniformNames[0],
                                                kShadowUniformNames[1],
                                                kShadowUniformNames[2],
                                                kShadowUniformNames[3],
                                                "scene",
                                                "rays",
                                                "caster_box",
                                                "shaft_look",
                                                "haze_color",
                                                kAirUniformNames[0],
                                                kAirUniformNames[1],
                                                kAirUniformNames[2],
                                                kAirUniformNames[3]};

float number(double value) { return static_cast<float>(value); }

void set_vec3(float (&to)[3], const glm::dvec3& from) {
    for (int n = 0; n < 3; ++n) to[n] = number(from[n]);
}

}  // namespace

base::Error LightShafts::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                               bool with_air) {
    with_air_ = with_air;
    const gl::TextureSettings texels{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, (width_px + 1) / 2,
                                     (height_px + 1) / 2};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), texels, gl::TargetDepth::none);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    if (base::Error error = grid_.start(gl, budget)) return error;
    base::FixedString<kMaxShaderText> fragment("#define SHADOWS 1\n");
    if (with_air) fragment.append("#define AIR 1\n");
    fragment.append(shader_text(k_shadow_frag));
    if (with_air) fragment.append(shader_text(k_air_frag));
    fragment.append(shader_text(k_shafts_frag));
    auto built = gl::build_program(
        gl, {"light shafts", shader_text(k_screen_vert), fragment.view(),
             base::Span<const gl::AttributeBinding>(kScreenAttributes), base::Span<const char* const>(kNames), true});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

void LightShafts::draw(gl::Gl& gl, const ShaftInput& input) {
    const terrain::View& view = input.view;
    target_.bind(gl);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    program_.use(gl);
    set_shadow_uniforms(gl, program_, 0, input.shadow, view.eye);
    if (with_air_) set_air_uniforms(gl, program_, kShaftAir, input.air);
    float rays[3][3];
    set_vec3(rays[0], view.forward);
    set_vec3(rays[1], view.right * view.half_width_tangent());
    set_vec3(rays[2], -view.down * view.half_height_tangent());
    gl->Uniform3fv(program_.uniform(kShaftRays), 3, rays[0]);
    const ShadowFrame& frame = *input.shadow.frame;
    const float box[6] = {number(frame.low_m.x),  number(frame.low_m.y),  number(frame.low_m.z),
                          number(frame.high_m.x), number(frame.high_m.y), number(frame.high_m.z)};
    gl->Uniform3fv(program_.uniform(kShaftBox), 2, box);
    gl->Uniform3f(program_.uniform(kShaftLook), number(input.strength), number(input.steps), number(input.haze_per_m));
    gl->Uniform3f(program_.uniform(kShaftHaze), number(input.haze.red / 255.0), number(input.haze.green / 255.0),
                  number(input.haze.blue / 255.0));
    gl->Uniform1i(program_.uniform(kShaftScene), 0);
    input.scene.bind(gl, 0);
    grid_.draw(gl);
}

void LightShafts::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    grid_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
