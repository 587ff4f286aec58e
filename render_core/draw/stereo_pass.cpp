#include "render_core/draw/stereo_pass.hpp"

#include <algorithm>

#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum Uniform : std::size_t { kPicture, kPart, kUniforms };

}  // namespace

gl::GlError StereoPass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                              std::uint32_t margin_px) {
    static constexpr const char* kNames[kUniforms] = {"picture", "part"};
    width_px_ = width_px;
    margin_px_ = margin_px;
    const gl::TextureSettings color{gl::TextureFormat::rgba8, gl::TextureFilter::linear, width_px + 2 * margin_px, height_px};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), color, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    if (gl::GlError error = grid_.start(gl, budget); !error.sentence.empty()) return error;
    auto built =
        gl::build_program(gl, {"eye picture", shader_text(k_screen_vert), shader_text(k_eye_picture_frag),
                               base::Span<const gl::AttributeBinding>(kScreenAttributes), base::Span<const char* const>(kNames)});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

std::int32_t StereoPass::screen_begins_px(EyeSide side, std::int32_t shift_px) const {
    const auto margin = static_cast<std::int32_t>(margin_px_);
    const std::int32_t shift = std::clamp(shift_px, -margin, margin);
    return side == EyeSide::left ? margin + shift : margin - shift;
}

void StereoPass::put(gl::Gl& gl, const base::Surface& surface, design::StereoMode mode, EyeSide side, std::int32_t shift_px) {
    gl::bind_surface(gl, surface);
    const bool is_left = side == EyeSide::left, is_anaglyph = mode == design::StereoMode::anaglyph;
    if (mode == design::StereoMode::side_by_side) begin_half(gl, surface, side);
    if (is_anaglyph) gl->ColorMask(is_left, !is_left, !is_left, GL_TRUE);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    target_.color().bind(gl, 0);
    program_.use(gl);
    const auto whole = static_cast<float>(target_.color().settings().width_px);
    gl->Uniform1i(program_.uniform(kPicture), 0);
    gl->Uniform4f(program_.uniform(kPart), static_cast<float>(screen_begins_px(side, shift_px)) / whole, 0,
                  static_cast<float>(width_px_) / whole, 1);
    grid_.draw(gl);
    if (is_anaglyph) gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    end_halves(gl, surface);
}

void StereoPass::begin_half(gl::Gl& gl, const base::Surface& surface, EyeSide side) {
    const auto half = static_cast<GLsizei>(surface.width() / 2);
    gl->Viewport(side == EyeSide::left ? 0 : half, 0, half, static_cast<GLsizei>(surface.height()));
}

void StereoPass::end_halves(gl::Gl& gl, const base::Surface& surface) {
    gl->Viewport(0, 0, static_cast<GLsizei>(surface.width()), static_cast<GLsizei>(surface.height()));
}

void StereoPass::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    grid_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
