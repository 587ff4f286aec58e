/// The scene as it was, over the one that is: while another design or other data take their place.
///
/// Memory, thread and failure are those of a KeptPicture.
#pragma once

#include "render_core/draw/kept_picture.hpp"

namespace tedavis::draw {

class SceneFade {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px) {
        return picture_.start(gl, budget, width_px, height_px);
    }
    [[nodiscard]] bool is_started() const { return picture_.is_started(); }
    /// Where the scene that is about to go is drawn once more.
    [[nodiscard]] const gl::RenderTarget& target() const { return picture_.target(); }
    /// Over the bound framebuffer, whose alpha stays. `share`: 0..1 of what was. Leaves depth test, culling and blending off.
    void draw(gl::Gl& gl, double share) const;
    void destroy(gl::Gl& gl) { picture_.destroy(gl); }

private:
    KeptPicture picture_;
};

}  // namespace tedavis::draw
