#include "render_core/gl/readback.hpp"

namespace tedavis::gl {

bool read_pixels(Gl& gl, std::uint32_t width, std::uint32_t height, base::Span<std::uint8_t> pixels) {
    const std::uint64_t bytes = std::uint64_t{4} * width * height;
    if (pixels.size() != bytes || bytes == 0) return false;
    static_cast<void>(gl.take_error());
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    const auto columns = static_cast<GLsizei>(width);
    const auto rows = static_cast<GLsizei>(height);
    if (gl.has(CallId::ReadnPixels)) {
        gl->ReadnPixels(0, 0, columns, rows, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes), pixels.data());
    } else {
        gl->ReadPixels(0, 0, columns, rows, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
    return gl.take_error() == GL_NO_ERROR;
}

}  // namespace tedavis::gl
