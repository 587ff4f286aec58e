/// Uniforms of shader programs for magnified objects. Within one part (earth/magnified_parts.hpp) a magnifier is an affine map of
/// its plane, so an object is drawn once for each part: the whole mesh is moved by the part's map, and fragments outside the part
/// are discarded (shaders/magnified.vert, magnified.frag). Neighbouring parts overlap by at least 0.05 m, so that no gaps show
/// between them. An object that no magnifier reaches is drawn once, by a program without magnifiers.
///
/// A program for magnified objects declares the uniforms kMagnifierUniformNames, calls magnified() and leave_other_parts(), and
/// is compiled with kMagnifiedDefine. Thread  the GL thread.
#pragma once

#include <string_view>

#include "render_core/earth/magnified_parts.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMagnifierUniforms = 2;
inline constexpr const char* kMagnifierUniformNames[kMagnifierUniforms] = {"lens", "lens_part"};
inline constexpr std::string_view kMagnifiedDefine = "#define MAGNIFIED 1\n";

/// Sets the uniforms of the program in use. `first`: index of kMagnifierUniformNames[0] in the program's list of uniforms.
/// `origin`: the point (ECEF, m) from which the positions given to magnified() are measured.
void set_magnifier_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const earth::MagnifiedPart& part,
                            const glm::dvec3& origin);

}  // namespace tedavis::draw
