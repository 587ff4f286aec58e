/// Reads drawn pixels into the caller's memory.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

/// RGBA8, bottom row first, tightly packed, from the bound framebuffer's lower left corner. Waits until drawing is complete.
/// Returns false when `pixels` does not have exactly width*height*4 bytes or GL reports an error; the pixels are then
/// unspecified.
[[nodiscard]] bool read_pixels(Gl& gl, std::uint32_t width, std::uint32_t height, base::Span<std::uint8_t> pixels);
/// The same of `rows` rows, the lowest of which is `first_row`; the bottom row is row 0.
[[nodiscard]] bool read_rows(Gl& gl, std::uint32_t first_row, std::uint32_t width, std::uint32_t rows,
                             base::Span<std::uint8_t> pixels);

}  // namespace tedavis::gl
