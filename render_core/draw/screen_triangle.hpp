/// One triangle that covers the whole viewport, for image passes.
///
/// Its corners are attribute 0 (vec2): (-1, -1), (3, -1), (-1, 3), which are clip coordinates.
///
/// Memory  24 bytes of the line symbology_vertices. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/gl/buffer.hpp"

namespace tedavis::draw {

class ScreenTriangle {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget);
    /// Draws the triangle with the current program and target.
    void draw(gl::Gl& gl) const;
    void destroy(gl::Gl& gl) { corners_.destroy(gl); }

private:
    gl::Buffer corners_;
};

}  // namespace tedavis::draw
