/// A picture as the bytes of a PNG file (ISO/IEC 15948), without a compressor: rows lie in stored blocks, so that the size is
/// known beforehand and no library is needed on a board.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/span.hpp"

namespace tedavis::target {

/// Bytes of the file of an RGB picture; edges of 1 to 16384 pixels.
[[nodiscard]] std::size_t png_bytes(std::uint32_t width_px, std::uint32_t height_px) noexcept;

/// `rgba`: 4 bytes a pixel, bottom row first, as GL reads it; alpha is left out. `out` has exactly png_bytes().
void write_png(std::uint32_t width_px, std::uint32_t height_px, base::Span<const std::uint8_t> rgba,
               base::Span<std::uint8_t> out) noexcept;

}  // namespace tedavis::target
