/// Rectangles of one color each that turn one picture into another, painted over a finished frame on its surface.
///
/// They need no program, buffer or texture, none of which can be made after the start of a display.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::host_sim {

/// Pixels from the top left corner.
struct PaintedRect {
    std::uint32_t left = 0, top = 0, width = 0, height = 0;
    std::array<std::uint8_t, 3> color{};
};

/// Returns rectangles that cover exactly the pixels whose color differs between two pictures of the same size, with the color of
/// `after`.
[[nodiscard]] std::vector<PaintedRect> changed_rects(const RgbaView& before, const RgbaView& after);
/// Paints on the bound framebuffer, which is `height_px` high; afterwards the scissor test is disabled, as at the begin of a
/// frame.
void paint_rects(gl::Gl& gl, std::uint32_t height_px, const std::vector<PaintedRect>& rects);

}  // namespace tedavis::host_sim
