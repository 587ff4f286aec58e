#include "render_core/draw/drawers/kept_picture.hpp"

#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum KeptUniform : std::size_t { kKeptTexture, kKeptPart, kKeptUniforms };

}  // namespace

base::Error KeptPicture::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px) {
    static constexpr const char* kNames[kKeptUniforms] = {"picture", "part"};
    const gl::TextureSettings color{gl::TextureFormat::rgba8, gl::TextureFilter::linear, width_px, height_px};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), color, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    if (base::Error error = grid_.start(gl, budget)) return error;
    auto built =
        gl::build_program(gl, {"kept picture", shader_text(k_screen_vert), shader_text(k_kept_picture_frag),
                               base::Span<const gl::AttributeBinding>(kScreenAttributes), base::Span<const char* const>(kNames)});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

void KeptPicture::draw(gl::Gl& gl, std::int32_t begins_px, std::uint32_t width_px) const {
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    target_.color().bind(gl, 0);
    program_.use(gl);
    const auto whole = static_cast<float>(target_.color().settings().width_px);
    gl->Uniform1i(program_.uniform(kKeptTexture), 0);
    gl->Uniform4f(program_.uniform(kKeptPart), static_cast<float>(begins_px) / whole, 0, static_cast<float>(width_px) / whole, 1);
    grid_.draw(gl);
}

void KeptPicture::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    grid_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
