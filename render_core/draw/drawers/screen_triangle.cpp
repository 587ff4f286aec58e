#include "render_core/draw/drawers/screen_triangle.hpp"

#include "render_core/effects/device.hpp"

namespace tedavis::draw {

base::Error ScreenTriangle::start(gl::Gl& gl, base::BudgetTable& budget) {
    constexpr float kCorners[] = {-1, -1, 3, -1, -1, 3};
    auto made = gl::make_buffer(gl, *budget.find(effects::kSymbologyVertices), gl::BufferKind::vertices, gl::BufferUse::fixed,
                                sizeof kCorners);
    if (!made.ok()) return made.error();
    corners_ = static_cast<gl::Buffer&&>(made.value());
    if (!corners_.upload(gl, 0, kCorners, sizeof kCorners)) return base::make_error("a triangle cannot be uploaded");
    return {};
}

void ScreenTriangle::draw(gl::Gl& gl) const {
    corners_.bind(gl);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->DisableVertexAttribArray(0);
}

}  // namespace tedavis::draw
