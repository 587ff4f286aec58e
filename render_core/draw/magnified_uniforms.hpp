/// Uniforms of programs that draw one part of what magnifiers move (earth/magnified_parts.hpp): the whole mesh is drawn with
/// the part's linear map, and fragments outside the part are discarded (shaders/magnified.vert, magnified.frag). Objects that
/// no magnifier reaches are drawn once, by programs without magnifiers.
///
/// They have the uniforms of kMagnifierUniformNames, call magnified() and leave_other_parts(), and are built with the line
/// kMagnifiedDefine. Thread  the GL thread.
#pragma once

#include <string_view>

#include "render_core/earth/magnified_parts.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMagnifierUniforms = 2;
inline constexpr const char* kMagnifierUniformNames[kMagnifierUniforms] = {"lens", "lens_part"};
inline constexpr std::string_view kMagnifiedDefine = "#define MAGNIFIED 1\n";

/// Sets the uniforms of the program in use; `first` is the index of the names in its list. Positions are relative to `origin`
/// (ECEF).
void set_magnifier_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const earth::MagnifiedPart& part,
                            const glm::dvec3& origin);

}  // namespace tedavis::draw
