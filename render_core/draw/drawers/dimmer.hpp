/// Multiplies every pixel of the finished display by one colour, for the panel's brightness.
///
/// Memory    a grid charged to the line `symbology_vertices`. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/draw/drawers/screen_grid.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

class Dimmer {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget);
    [[nodiscard]] bool is_started() const { return program_.valid(); }
    /// Dims the bound framebuffer; alpha is unchanged. `white` is 0..1 per channel. Leaves depth test, culling and blending
    /// off.
    void draw(gl::Gl& gl, const glm::dvec3& white) const;
    void destroy(gl::Gl& gl);

private:
    gl::Program program_;
    ScreenGrid grid_;
};

}  // namespace tedavis::draw
