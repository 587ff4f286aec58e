#include "render_core/draw/drawers/view_projection.hpp"

#include <glm/geometric.hpp>

namespace tedavis::draw {

glm::dmat4 view_projection(const terrain::View& view, const DepthRange& range, const glm::dvec3& eye_fraction) {
    const double n = range.near_m, f = range.far_m;
    const double sx = 1.0 / view.half_width_tangent(), sy = 1.0 / view.half_height_tangent();
    const glm::dvec3 rows[3] = {view.right * sx, -view.down * sy, view.forward};
    const double zs = (f + n) / (f - n), zo = -2.0 * f * n / (f - n);
    glm::dmat4 m(0.0);
    for (int c = 0; c < 3; ++c) m[c] = {rows[0][c], rows[1][c], rows[2][c] * zs, rows[2][c]};
    const double depth = -glm::dot(rows[2], eye_fraction);
    m[3] = {-glm::dot(rows[0], eye_fraction), -glm::dot(rows[1], eye_fraction), depth * zs + zo, depth};
    return m;
}

void set_matrix(gl::Gl& gl, GLint location, const glm::dmat4& matrix) {
    float values[16];
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) values[4 * c + r] = static_cast<float>(matrix[c][r]);
    gl->UniformMatrix4fv(location, 1, GL_FALSE, values);
}

}  // namespace tedavis::draw
