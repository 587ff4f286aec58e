#include "render_core/draw/drawers/view_effects_pass.hpp"

#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/drawers/light_shafts.hpp"
#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum EffectUniform : std::size_t {
    kEffectScene,
    kEffectSceneSize,
    kEffectFocus,
    kEffectSquares,
    kEffectSurroundings,
    kEffectShafts,
    kEffectUniforms
};

}  // namespace

double distance_code(double distance_m) noexcept {
    return std::fmin(std::log2(1 + distance_m / kDistanceCodeStart_m) / kDistanceCodeOctaves, 254.0 / 255);
}

base::Error ViewEffectsPass::build_program(gl::Gl& gl, bool blurs, bool smooths, bool shafts) {
    static constexpr const char* kNames[kEffectUniforms] = {"scene", "scene_size", "focus", "squares", "surroundings", "shafts"};
    base::FixedString<kMaxShaderText> fragment;
    if (blurs) {
        fragment.append(square_definition(blur_.square_px()).view());
        fragment.append("#define BLUR 1\n");
        fragment.append(shader_text(k_blur_radius_frag));
    }
    if (smooths) fragment.append("#define SMOOTH 1\n");
    if (shafts) fragment.append("#define SHAFTS 1\n");
    if (shafts && with_air_) fragment.append("#define AIR 1\n");
    fragment.append(shader_text(k_view_effects_frag));
    auto built = gl::build_program(
        gl, {"view effects", shader_text(k_screen_vert), fragment.view(),
             base::Span<const gl::AttributeBinding>(kScreenAttributes), base::Span<const char* const>(kNames), true});
    if (!built.ok()) return built.error();
    programs_[blurs ? 1 : 0][smooths ? 1 : 0][shafts ? 1 : 0] = built.value();
    return {};
}

base::Error ViewEffectsPass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                   const PictureEffects& effects, bool with_air) {
    with_air_ = with_air;
    const gl::TextureSettings color{gl::TextureFormat::rgba8, gl::TextureFilter::linear, width_px, height_px};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), color, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    if (base::Error error = grid_.start(gl, budget)) return error;
    if (effects.blurs)
        if (base::Error error = blur_.start(gl, budget, width_px, height_px, effects.blur_square_px)) return error;
    for (const bool blurs : {false, true})
        for (const bool smooths : {false, true})
            for (const bool shafts : {false, true}) {
                const bool is_asked_for =
                    (!blurs || effects.blurs) && (!smooths || effects.smooths) && (!shafts || effects.has_shafts);
                if (!is_asked_for || !(blurs || smooths || shafts)) continue;
                if (base::Error error = build_program(gl, blurs, smooths, shafts)) return error;
            }
    return {};
}

void ViewEffectsPass::set_uniforms(gl::Gl& gl, const gl::Program& program, const ViewEffectsInput& input) {
    const gl::TextureSettings& size = target_.color().settings();
    gl->Uniform1i(program.uniform(kEffectScene), 0);
    gl->Uniform2f(program.uniform(kEffectSceneSize), static_cast<float>(size.width_px), static_cast<float>(size.height_px));
    set_focus_uniform(gl, program.uniform(kEffectFocus), input.focus);
    gl->Uniform1i(program.uniform(kEffectSquares), kBlurUnit);
    gl->Uniform1i(program.uniform(kEffectSurroundings), kBlurUnit + 1);
    gl->Uniform1i(program.uniform(kEffectShafts), static_cast<GLint>(LightShafts::kUnit));
}

void ViewEffectsPass::finish(gl::Gl& gl, const gl::DrawPlace& place, const ViewEffectsInput& input) {
    const gl::Program& program = programs_[input.blurs ? 1 : 0][input.smooths ? 1 : 0][input.shafts != nullptr ? 1 : 0];
    TEDAVIS_CHECK(program.valid());
    if (input.blurs) blur_.draw(gl, grid_, target_.color(), input.focus);
    place.bind(gl);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    target_.color().bind(gl, 0);
    if (input.blurs) blur_.bind(gl, kBlurUnit);
    if (input.shafts != nullptr) input.shafts->bind(gl, LightShafts::kUnit);
    program.use(gl);
    set_uniforms(gl, program, input);
    grid_.draw(gl);
}

void ViewEffectsPass::destroy(gl::Gl& gl) {
    for (auto& of_blur : programs_)
        for (auto& of_edges : of_blur)
            for (gl::Program& program : of_edges) program.destroy(gl);
    grid_.destroy(gl);
    blur_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
