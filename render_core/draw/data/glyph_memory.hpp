/// The memory that the glyph drawer takes from its budget lines. `has_instances`: GlyphDrawer::has_instances() of the device.
/// Pure; any thread.
#pragma once

#include <cstdint>

#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/draw/data/glyph_shapes.hpp"

namespace tedavis::draw {

/// A vertex of a glyph on devices without instances.
struct GlyphCorner {
    float place[3];
    std::int8_t normal[4];
    std::uint8_t rgba[4];
};
static_assert(sizeof(GlyphCorner) == 20);
inline constexpr std::uint32_t kIndicesACorner = 3;
inline constexpr std::uint64_t kGlyphShapeBytes =
    GlyphShapes::kMaxVertices * sizeof(GlyphVertex) + GlyphShapes::kMaxIndices * sizeof(std::uint16_t);

/// Bytes of the arena that GlyphDrawer::start() takes.
[[nodiscard]] std::uint64_t glyph_drawer_bytes(bool has_instances, std::uint64_t gpu_bytes) noexcept;
/// Number of instances that fit in GPU memory; unlimited on devices without instances.
[[nodiscard]] std::uint32_t glyph_instances_within(bool has_instances, std::uint64_t gpu_bytes) noexcept;
[[nodiscard]] std::uint32_t glyph_corners_within(std::uint64_t gpu_bytes) noexcept;

}  // namespace tedavis::draw
