#include "render_core/draw/drawers/stereo_pass.hpp"

namespace tedavis::draw {

base::Error StereoPass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                              std::uint32_t margin_px) {
    width_px_ = width_px;
    margin_px_ = margin_px;
    return picture_.start(gl, budget, width_px + 2 * margin_px, height_px);
}

void StereoPass::put(gl::Gl& gl, const base::Surface& surface, design::StereoMode mode, EyeSide side, std::int32_t shift_px) {
    gl::bind_surface(gl, surface);
    const bool is_left = side == EyeSide::left, is_anaglyph = mode == design::StereoMode::anaglyph;
    if (mode == design::StereoMode::side_by_side) begin_half(gl, surface, side);
    if (is_anaglyph) gl->ColorMask(is_left, !is_left, !is_left, GL_TRUE);
    gl->Disable(GL_BLEND);
    picture_.draw(gl, screen_begins_px(margin_px_, side, shift_px), width_px_);
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

}  // namespace tedavis::draw
