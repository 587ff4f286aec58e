#include "render_core/draw/data/glyph_room.hpp"

#include <algorithm>
#include <cstddef>

#include "render_core/draw/data/glyph_memory.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

GlyphRoom glyph_room(bool has_instances, std::uint64_t cpu_bytes, std::uint64_t gpu_bytes, std::uint32_t fields) noexcept {
    const std::uint64_t none = scene::GlyphSelection::bytes_needed(0) + alignof(std::max_align_t);
    const std::uint64_t taken = glyph_drawer_bytes(has_instances, gpu_bytes) + none;
    if (cpu_bytes <= taken || fields == 0) return {};
    const std::uint64_t rest = cpu_bytes - taken;
    const std::uint64_t a_glyph =
        scene::GlyphSelection::bytes_needed(1) - scene::GlyphSelection::bytes_needed(0) + sizeof(GlyphInstance);
    const auto affordable = static_cast<std::uint64_t>(kGlyphShare * static_cast<double>(rest)) / a_glyph;
    GlyphRoom room;
    room.glyphs =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(affordable, glyph_instances_within(has_instances, gpu_bytes)));
    const std::uint32_t sites = scene::GlyphField::sites_within((rest - room.glyphs * a_glyph) / fields);
    if (sites < scene::kMinGlyphSites || room.glyphs == 0) return {};
    room.sites = sites * fields;
    return room;
}

}  // namespace tedavis::draw
