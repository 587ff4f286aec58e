#include "render_core/draw/data/glyph_memory.hpp"

#include <algorithm>
#include <cstddef>

namespace tedavis::draw {

std::uint32_t glyph_instances_within(bool has_instances, std::uint64_t gpu_bytes) noexcept {
    if (!has_instances) return 0xFFFFFFFFu;
    return gpu_bytes < kGlyphShapeBytes ? 0 : static_cast<std::uint32_t>((gpu_bytes - kGlyphShapeBytes) / sizeof(GlyphInstance));
}

std::uint32_t glyph_corners_within(std::uint64_t gpu_bytes) noexcept {
    constexpr std::uint64_t kMaxCorners = 65'536;  // that 16 bits number
    constexpr std::uint64_t kACorner = sizeof(GlyphCorner) + kIndicesACorner * sizeof(std::uint16_t);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(gpu_bytes / kACorner, kMaxCorners));
}

std::uint64_t glyph_drawer_bytes(bool has_instances, std::uint64_t gpu_bytes) noexcept {
    const std::uint64_t shapes = sizeof(GlyphShapes) + 3 * alignof(std::max_align_t);
    if (has_instances) return shapes;
    return shapes +
           std::uint64_t{glyph_corners_within(gpu_bytes)} * (sizeof(GlyphCorner) + kIndicesACorner * sizeof(std::uint16_t));
}

}  // namespace tedavis::draw
