/// Divides a device's budget lines for glyphs. Pure; any thread.
#pragma once

#include <cstdint>

namespace tedavis::draw {

struct GlyphRoom {
    std::uint32_t sites = 0;   ///< of all fields together (scene::GlyphField), 0 where there is no room for glyphs
    std::uint32_t glyphs = 0;  ///< per frame: of the selection (scene::GlyphSelection) and of the batch
};

/// Divides the bytes of the lines scene_glyphs (`cpu_bytes`) and scene_glyph_vertices (`gpu_bytes`) for so many fields. The
/// drawer's own memory is subtracted first; at most kGlyphShare of the rest is for the glyphs of a frame. `has_instances`:
/// GlyphDrawer::has_instances() of the device.
[[nodiscard]] GlyphRoom glyph_room(bool has_instances, std::uint64_t cpu_bytes, std::uint64_t gpu_bytes,
                                   std::uint32_t fields) noexcept;
/// Returns the bytes of the line scene_glyphs from which on glyph_room() has room for glyphs, if `gpu_bytes` suffice.
[[nodiscard]] std::uint64_t least_glyph_bytes(bool has_instances, std::uint64_t gpu_bytes, std::uint32_t fields) noexcept;
inline constexpr double kGlyphShare = 0.2;

}  // namespace tedavis::draw
