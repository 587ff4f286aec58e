/// The first lines of every shader, which let the same text compile in both lanes.
///
/// A shader file has no #version and writes:
///   vertex    VERTEX_IN vec3 position;   VARYING vec4 tint;   void main() { gl_Position = ...; }
///   fragment  VARYING vec4 tint;         void main() { FRAGMENT_COLOR = TEXTURE2D(atlas, uv) * tint; }
/// VARYING is written alike on both sides. LANE_ES2 or LANE_ES3 is defined as 1. Floats are highp; on an ES 2.0 device whose
/// fragment shaders have only mediump a uniform must not be read by both shaders.
/// Keep to what OpenGL SC 2.0 promises: `for` with constant bounds, no `while`, no samplers in vertex shaders.
#pragma once

#include <string_view>

#include "render_core/effects/device_capability.hpp"

namespace tedavis::gl {

enum class ShaderStage : unsigned char { vertex, fragment };

/// Returns the prefix; it ends so that the compiler's line numbers are those of the shader file.
[[nodiscard]] std::string_view shader_prefix(effects::Lane lane, ShaderStage stage);

}  // namespace tedavis::gl
