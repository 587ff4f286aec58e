#include "render_core/draw/drawers/page_atlas.hpp"

#include <cmath>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::draw {
namespace {

using design::BakedMap;
using terrain::kAttributePosts;
using terrain::kHorizonPosts;

constexpr BakedMap kPageMaps[] = {BakedMap::form, BakedMap::light, BakedMap::aperture, BakedMap::horizon};

/// Of the square that holds so many pages.
std::uint32_t side_px(std::uint32_t slots, std::uint32_t page_px) {
    std::uint32_t side = 1;
    while ((side / page_px) * (side / page_px) < slots) side *= 2;
    return side;
}

std::uint32_t page_px_of(BakedMap map) { return map == BakedMap::horizon ? kHorizonPosts : kAttributePosts; }

gl::TextureSettings settings_of(BakedMap map, std::uint32_t slots) {
    const std::uint32_t side = side_px(slots, page_px_of(map));
    return {map == BakedMap::horizon ? gl::TextureFormat::r8 : gl::TextureFormat::rgba8, gl::TextureFilter::linear, side, side};
}

gl::TexelRect place_of(std::uint32_t slot, std::uint32_t slots, std::uint32_t page_px) {
    const std::uint32_t across = side_px(slots, page_px) / page_px;
    return {slot % across * page_px, slot / across * page_px, page_px, page_px};
}

bool is_needed(const design::MapSet& maps, bool coast, BakedMap map) {
    return maps.has(map) || (coast && map == BakedMap::light);
}

std::size_t index_of(BakedMap map) { return static_cast<std::size_t>(map); }

}  // namespace

std::uint64_t PageAtlas::bytes_needed(const design::MapSet& maps, bool coast, std::uint32_t slots) {
    std::uint64_t bytes = 0;
    for (const BakedMap map : kPageMaps)
        if (is_needed(maps, coast, map)) bytes += gl::texture_bytes(settings_of(map, slots));
    return bytes;
}

base::Error PageAtlas::start(gl::Gl& gl, base::BudgetLine& line, const design::MapSet& maps, bool coast, std::uint32_t slots,
                             base::Arena& staging) {
    TEDAVIS_CHECK(slots > 0);
    horizon_ = staging.allocate_array<std::uint8_t>(std::size_t{kHorizonPosts} * kHorizonPosts);
    if (horizon_.empty()) return base::shortage_error(effects::kStaging, staging, "a horizon page");
    for (const BakedMap map : kPageMaps) {
        if (!is_needed(maps, coast, map)) continue;
        auto texture = gl::make_texture(gl, line, settings_of(map, slots));
        if (!texture.ok()) return texture.error();
        textures_[index_of(map)] = static_cast<gl::Texture&&>(texture.value());
    }
    light_is_for_coasts_ = !maps.has(BakedMap::light);
    slots_ = slots;
    return {};
}

bool PageAtlas::upload(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page, bool coast) {
    const gl::TexelRect part = place_of(slot, slots_, kAttributePosts);
    const void* const texels[] = {page.form, page.light, page.aperture};
    for (std::size_t map = 0; map < 3; ++map) {
        if (map == index_of(BakedMap::light) && light_is_for_coasts_ && !coast) continue;
        if (textures_[map].valid() && !textures_[map].upload(gl, part, texels[map])) return false;
    }
    return true;
}

bool PageAtlas::upload_horizon(gl::Gl& gl, std::uint32_t slot, const terrain::AttributePage& page, double azimuth_rad,
                               double east_m, double north_m) {
    const gl::Texture& texture = textures_[index_of(BakedMap::horizon)];
    if (!texture.valid()) return true;
    const terrain::HorizonBracket bracket = terrain::bracket_azimuth(azimuth_rad, east_m, north_m);
    const std::uint8_t* first = page.horizon[bracket.first];
    const std::uint8_t* second = page.horizon[bracket.second];
    const auto weight = static_cast<int>(std::lround(256 * bracket.weight));
    for (std::size_t n = 0; n < horizon_.size(); ++n)
        horizon_[n] = static_cast<std::uint8_t>((first[n] * (256 - weight) + second[n] * weight + 128) / 256);
    return texture.upload(gl, place_of(slot, slots_, kHorizonPosts), horizon_.data());
}

void PageAtlas::bind(gl::Gl& gl) const {
    // Unit 0 is the palette's.
    for (std::size_t map = 0; map < design::kBakedMaps; ++map)
        if (textures_[map].valid()) textures_[map].bind(gl, static_cast<std::uint32_t>(map + 1));
}

PageOrigin PageAtlas::origin(std::uint32_t slot) const {
    const gl::TexelRect map = place_of(slot, slots_, kAttributePosts), horizon = place_of(slot, slots_, kHorizonPosts);
    const auto middle = [](std::uint32_t texel) { return static_cast<float>(texel) + 0.5f; };
    return {middle(map.x), middle(map.y), middle(horizon.x), middle(horizon.y)};
}

float PageAtlas::map_scale() const { return 1.0f / static_cast<float>(side_px(slots_, kAttributePosts)); }
float PageAtlas::horizon_scale() const { return 1.0f / static_cast<float>(side_px(slots_, kHorizonPosts)); }

void PageAtlas::destroy(gl::Gl& gl) {
    for (gl::Texture& texture : textures_) texture.destroy(gl);
}

}  // namespace tedavis::draw
