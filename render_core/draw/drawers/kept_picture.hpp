/// Keeps a scene's picture off screen and draws a part of it over the whole bound framebuffer.
///
/// Memory    a colour and depth target from the budget line render_targets, a grid from `symbology_vertices`. Thread  the GL
///           thread. Failure  start(): one sentence.
#pragma once

#include "render_core/draw/drawers/screen_grid.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

class KeptPicture {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    [[nodiscard]] const gl::RenderTarget& target() const { return target_; }
    /// Draws `width_px` columns from `begins_px` on, at full height, with the caller's blending. Depth test and culling are off
    /// afterwards.
    void draw(gl::Gl& gl, std::int32_t begins_px, std::uint32_t width_px) const;
    void draw(gl::Gl& gl) const { draw(gl, 0, target_.color().settings().width_px); }
    void destroy(gl::Gl& gl);

private:
    gl::RenderTarget target_;
    gl::Program program_;
    ScreenGrid grid_;
};

}  // namespace tedavis::draw
