/// Cross-fade: draws the previous scene over the current one while the design or the data change.
///
/// Memory, thread and failure are those of a KeptPicture.
#pragma once

#include "render_core/draw/drawers/kept_picture.hpp"

namespace tedavis::draw {

class SceneFade {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px) {
        return picture_.start(gl, budget, width_px, height_px);
    }
    [[nodiscard]] bool is_started() const { return picture_.is_started(); }
    /// The target into which the previous scene is drawn once more.
    [[nodiscard]] const gl::RenderTarget& target() const { return picture_.target(); }
    /// Draws over the bound framebuffer, whose alpha is unchanged. `share` 0..1 is the opacity of the previous scene. Leaves
    /// depth test, culling and blending off.
    void draw(gl::Gl& gl, double share) const;
    void destroy(gl::Gl& gl) { picture_.destroy(gl); }

private:
    KeptPicture picture_;
};

}  // namespace tedavis::draw
