#include "render_core/draw/data/glyph_room.hpp"

#include <algorithm>
#include <cstddef>

#include "render_core/draw/data/glyph_memory.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

namespace {

std::uint64_t bytes_beside_glyphs(bool has_instances, std::uint64_t gpu_bytes) noexcept {
    return glyph_drawer_bytes(has_instances, gpu_bytes) + scene::GlyphSelection::bytes_needed(0) + alignof(std::max_align_t);
}

std::uint64_t bytes_of_glyph() noexcept {
    return scene::GlyphSelection::bytes_needed(1) - scene::GlyphSelection::bytes_needed(0) + sizeof(GlyphInstance);
}

}  // namespace

GlyphRoom glyph_room(bool has_instances, std::uint64_t cpu_bytes, std::uint64_t gpu_bytes, std::uint32_t fields) noexcept {
    const std::uint64_t taken = bytes_beside_glyphs(has_instances, gpu_bytes);
    if (cpu_bytes <= taken || fields == 0) return {};
    const std::uint64_t rest = cpu_bytes - taken;
    const std::uint64_t a_glyph = bytes_of_glyph();
    const auto affordable = static_cast<std::uint64_t>(kGlyphShare * static_cast<double>(rest)) / a_glyph;
    GlyphRoom room;
    room.glyphs =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(affordable, glyph_instances_within(has_instances, gpu_bytes)));
    const std::uint32_t sites = scene::GlyphField::sites_within((rest - room.glyphs * a_glyph) / fields);
    if (sites < scene::kMinGlyphSites || room.glyphs == 0) return {};
    room.sites = sites * fields;
    return room;
}

/// The sites need their share of what the glyphs leave, and a glyph its share of all.
std::uint64_t least_glyph_bytes(bool has_instances, std::uint64_t gpu_bytes, std::uint32_t fields) noexcept {
    const auto shared = [](double bytes, double share) { return static_cast<std::uint64_t>(bytes / share) + 1; };
    const std::uint64_t sites = (scene::GlyphField::bytes_needed(scene::kMinGlyphSites) + 1) * fields;
    const std::uint64_t for_sites = shared(static_cast<double>(sites), 1 - kGlyphShare),
                        for_glyphs = shared(static_cast<double>(bytes_of_glyph()), kGlyphShare);
    return bytes_beside_glyphs(has_instances, gpu_bytes) + std::max(for_sites, for_glyphs);
}

}  // namespace tedavis::draw
