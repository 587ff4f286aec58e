/// Draws indexed triangles with the call that the device has (DrawElements, or DrawRangeElements on OpenGL SC 2.0).
#pragma once

#include <cstdint>

#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

/// A range of the bound index buffer; indices are 16 bits and lie in [0, last_vertex].
struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t last_vertex = 0;
};

/// Draws a range; does nothing for a count of 0.
void draw_triangles(Gl& gl, const IndexRange& range);

}  // namespace tedavis::gl
