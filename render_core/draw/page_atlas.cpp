#include "render_core/draw/page_atlas.hpp"

#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::draw {
namespace {

using design::BakedMap;
using terrain::kAttributePosts;
using terrain::kHorizonPosts;

constexpr BakedMap kPageMaps[] = {BakedMap::form, BakedMap::light, BakedMap::aperture, BakedMap::horizon};

std::uint32_t side_of(std::uint32_t slots) {
    std::uint32_t side = 1;
    while (side * side < slots) ++side;
    return side;
}

gl::TextureSettings settings_of(BakedMap map, std::uint32_t slots) {
    const bool horizon = map == BakedMap::horizon;
    const std::uint32_t side_px = side_of(slots) * (horizon ? kHorizonPosts : kAttributePosts);
    return {horizon ? gl::TextureFormat::r8 : gl::TextureFormat::rgba8, gl::TextureFilter::linear, side_px, side_px};
}

std::size_t index_of(BakedMap map) { return static_cast<std::size_t>(map); }

}  // namespace

std::uint64_t PageAtlas::bytes_needed(const design::TerrainStyle& style, std::uint32_t slots) {
    std::uint64_t bytes = 0;
    for (const BakedMap map : kPageMaps)
        if (needs_map(style, map)) bytes += gl::texture_bytes(settings_of(map, slots));
    return bytes;
}

gl::GlError PageAtlas::start(gl::Gl& gl, base::BudgetLine& line, const design::TerrainStyle& style, std::uint32_t slots,
                             base::Arena& staging) {
    TEDAVIS_CHECK(slots > 0);
    horizon_ = staging.allocate_array<std::uint8_t>(std::size_t{kHorizonPosts} * kHorizonPosts);
    if (horizon_.empty())
        return gl::make_error("the budget line 'staging' is too small for a horizon page; raise it in the device file");
    for (const BakedMap map : kPageMaps) {
        if (!needs_map(style, map)) continue;
        auto texture = gl::make_texture(gl, line, settings_of(map, slots));
        if (!texture.ok()) return texture.error();
        textures_[index_of(map)] = static_cast<gl::Texture&&>(texture.value());
    }
    slots_ = slots;
    return {};
}

std::uint32_t PageAtlas::side() const { return side_of(slots_); }

bool PageAtlas::upload(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page) {
    const gl::TexelRect part{slot % side() * kAttributePosts, slot / side() * kAttributePosts, kAttributePosts, kAttributePosts};
    const void* const texels[] = {page.form, page.light, page.aperture};
    for (std::size_t map = 0; map < 3; ++map)
        if (textures_[map].valid() && !textures_[map].upload(gl, part, texels[map])) return false;
    return true;
}

bool PageAtlas::upload_horizon(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page, double azimuth_rad,
                               double east_m, double north_m) {
    const gl::Texture& texture = textures_[index_of(BakedMap::horizon)];
    if (!texture.valid()) return true;
    const terrain::HorizonBracket bracket = terrain::bracket_azimuth(azimuth_rad, east_m, north_m);
    const std::uint8_t* first = page.horizon[bracket.first];
    const std::uint8_t* second = page.horizon[bracket.second];
    const auto weight = static_cast<int>(256 * bracket.weight + 0.5);
    for (std::size_t n = 0; n < horizon_.size(); ++n)
        horizon_[n] = static_cast<std::uint8_t>((first[n] * (256 - weight) + second[n] * weight + 128) / 256);
    const gl::TexelRect part{slot % side() * kHorizonPosts, slot / side() * kHorizonPosts, kHorizonPosts, kHorizonPosts};
    return texture.upload(gl, part, horizon_.data());
}

void PageAtlas::bind(gl::Gl& gl) const {
    // Unit 0 is the palette's.
    for (std::size_t map = 0; map < design::kBakedMaps; ++map)
        if (textures_[map].valid()) textures_[map].bind(gl, static_cast<std::uint32_t>(map + 1));
}

PageWindow PageAtlas::map_window(std::uint32_t slot) const {
    const float whole = static_cast<float>(side() * kAttributePosts);
    const auto first = [&](std::uint32_t n) { return (static_cast<float>(n * kAttributePosts) + 0.5f) / whole; };
    return {1.0f / whole, first(slot % side()), first(slot / side())};
}

PageWindow PageAtlas::horizon_window(std::uint32_t slot) const {
    const PageWindow map = map_window(slot);
    const float whole = static_cast<float>(side() * kHorizonPosts);
    const float scale = 0.5f / whole / map.scale;  // two texels of a map lie between two of the horizon
    const auto first = [&](std::uint32_t n) { return (static_cast<float>(n * kHorizonPosts) + 0.5f) / whole; };
    return {scale, first(slot % side()) - map.offset_x * scale, first(slot / side()) - map.offset_y * scale};
}

void PageAtlas::destroy(gl::Gl& gl) {
    for (gl::Texture& texture : textures_) texture.destroy(gl);
}

}  // namespace tedavis::draw
