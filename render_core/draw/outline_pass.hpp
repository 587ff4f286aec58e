/// Draws the scene off-screen and then with its silhouettes on the surface: lines where the depth jumps (Saito, Takahashi,
/// "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990), found in the distance code that terrain.frag writes into alpha.
///
/// Memory    a colour and depth target from the budget line render_targets. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/surface.hpp"
#include "render_core/design/color.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

class OutlinePass {
public:
    [[nodiscard]] gl::GlError start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px);
    [[nodiscard]] bool is_started() const { return target_.valid(); }
    /// What is drawn from here on goes off-screen.
    void begin(gl::Gl& gl) const { target_.bind(gl); }
    /// Puts the picture on the surface; `strength` 0..1.
    void finish(gl::Gl& gl, const base::Surface& surface, design::Color line, double strength) const;
    void destroy(gl::Gl& gl);

private:
    gl::RenderTarget target_;
    gl::Buffer corners_;
    gl::Program program_;
};

}  // namespace tedavis::draw
