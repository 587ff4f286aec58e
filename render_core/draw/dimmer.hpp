/// Multiplies every pixel of the finished display with one colour: the panel's brightness.
///
/// Memory    a grid from the line `symbology_vertices`. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/draw/screen_grid.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

class Dimmer {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget);
    [[nodiscard]] bool is_started() const { return program_.valid(); }
    /// Of the bound framebuffer; alpha stays. `white`: 0..1. Leaves depth test, culling and blending off.
    void draw(gl::Gl& gl, const glm::dvec3& white) const;
    void destroy(gl::Gl& gl);

private:
    gl::Program program_;
    ScreenGrid grid_;
};

}  // namespace tedavis::draw
