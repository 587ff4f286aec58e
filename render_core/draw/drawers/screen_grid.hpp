/// A grid over the whole screen for screen.vert: 32 x 24 cells, so that a view ray's elevation, computed at their corners, is
/// right to a quarter of a pixel in between for fields of view up to 90 degrees.
///
/// Memory    vertices and indices from the line `symbology_vertices`. Thread  the GL thread. Failure  start(): one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/screen_part.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

inline constexpr gl::AttributeBinding kScreenAttributes[] = {{"position", 0}};

class ScreenGrid {
public:
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetTable& budget);
    /// Draws all cells with the program in use.
    void draw(gl::Gl& gl) const { draw_cells(gl, {}, true); }
    /// Draws the cells that reach into the part, or with `inside` false the others.
    void draw_cells(gl::Gl& gl, const ScreenPart& part, bool inside) const;
    void destroy(gl::Gl& gl);

private:
    gl::Buffer vertices_, indices_;
};

}  // namespace tedavis::draw
