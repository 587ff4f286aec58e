#include "render_core/gl/readback.hpp"

namespace tedavis::gl {

bool read_pixels(Gl& gl, std::uint32_t width, std::uint32_t height, base::Span<std::uint8_t> pixels) {
    return read_rows(gl, 0, width, height, pixels);
}

bool read_rows(Gl& gl, std::uint32_t first_row, std::uint32_t width, std::uint32_t rows, base::Span<std::uint8_t> pixels) {
    const std::uint64_t bytes = std::uint64_t{4} * width * rows;
    if (pixels.size() != bytes || bytes == 0) return false;
    static_cast<void>(gl.take_error());
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    const auto y = static_cast<GLint>(first_row);
    const auto across = static_cast<GLsizei>(width), down = static_cast<GLsizei>(rows);
    if (gl.has(CallId::ReadnPixels)) {
        gl->ReadnPixels(0, y, across, down, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bytes), pixels.data());
    } else {
        gl->ReadPixels(0, y, across, down, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
    return gl.take_error() == GL_NO_ERROR;
}

}  // namespace tedavis::gl
