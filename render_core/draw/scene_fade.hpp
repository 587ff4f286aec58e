/// The scene as it was, over the one that is: while another design or other data take their place.
///
/// Memory    a colour and depth target from the budget line render_targets, a grid from `symbology_vertices`. Thread  the GL
///           thread. Failure  start(): one sentence.
#pragma once

#include "render_core/draw/screen_grid.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

class SceneFade {
public:
    [[nodiscard]] gl::GlError start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    /// Where the scene that is about to go is drawn once more.
    [[nodiscard]] const gl::RenderTarget& target() const { return target_; }
    /// Over the bound framebuffer, whose alpha stays. `share`: 0..1 of what was. Leaves depth test, culling and blending off.
    void draw(gl::Gl& gl, double share) const;
    void destroy(gl::Gl& gl);

private:
    gl::RenderTarget target_;
    gl::Program program_;
    ScreenGrid grid_;
};

}  // namespace tedavis::draw
