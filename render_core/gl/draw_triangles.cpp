#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::gl {

void draw_triangles(Gl& gl, const IndexRange& range) {
    if (range.count == 0) return;
    const auto count = static_cast<GLsizei>(range.count);
    const void* offset = reinterpret_cast<const void*>(std::uintptr_t{range.first} * sizeof(GLushort));
    if (gl.has(CallId::DrawRangeElements)) {
        gl->DrawRangeElements(GL_TRIANGLES, 0, range.last_vertex, count, GL_UNSIGNED_SHORT, offset);
    } else {
        gl->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, offset);
    }
}

}  // namespace tedavis::gl
