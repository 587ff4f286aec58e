#include "render_core/draw/scene_fade.hpp"

#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum Uniform : std::size_t { kPicture, kPart, kUniforms };

}  // namespace

gl::GlError SceneFade::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px) {
    static constexpr const char* kNames[kUniforms] = {"picture", "part"};
    const gl::TextureSettings color{gl::TextureFormat::rgba8, gl::TextureFilter::linear, width_px, height_px};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), color, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    if (gl::GlError error = grid_.start(gl, budget); !error.sentence.empty()) return error;
    auto built =
        gl::build_program(gl, {"scene fade", shader_text(k_screen_vert), shader_text(k_eye_picture_frag),
                               base::Span<const gl::AttributeBinding>(kScreenAttributes), base::Span<const char* const>(kNames)});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

void SceneFade::draw(gl::Gl& gl, double share) const {
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Enable(GL_BLEND);
    gl->BlendColor(0, 0, 0, static_cast<float>(share));
    gl->BlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_ZERO, GL_ONE);
    target_.color().bind(gl, 0);
    program_.use(gl);
    gl->Uniform1i(program_.uniform(kPicture), 0);
    gl->Uniform4f(program_.uniform(kPart), 0, 0, 1, 1);
    grid_.draw(gl);
    gl->Disable(GL_BLEND);
}

void SceneFade::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    grid_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
