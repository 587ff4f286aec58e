/// Projection from metres relative to the eye point, in ECEF axes, to clip space (OpenGL's, z -1..1). Pure functions; any
/// thread.
#pragma once

#include <glm/mat4x4.hpp>

#include "render_core/draw/depth_plan.hpp"
#include "render_core/gl/gl.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// Returns the perspective of a view, for positions in a frame with ECEF axes in which the eye point is at `eye_fraction`, m.
[[nodiscard]] glm::dmat4 view_projection(const terrain::View& view, const DepthRange& range,
                                         const glm::dvec3& eye_fraction = glm::dvec3(0));

/// Sets a mat4 uniform of the program in use.
void set_matrix(gl::Gl& gl, GLint location, const glm::dmat4& matrix);

}  // namespace tedavis::draw
