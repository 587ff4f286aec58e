#include "render_core/draw/drawers/drape_atlas.hpp"

namespace tedavis::draw {
namespace {

using terrain::kDrapePosts;

constexpr std::uint32_t kNowherePx = 2;  // so that no filter reaches what lies beside it

std::uint32_t pages_across(std::uint32_t side_px) { return side_px / kDrapePosts; }

/// Of the square that holds so many pages. A power of two is no multiple of 129: there is room beside them.
std::uint32_t side_px(std::uint32_t slots) {
    std::uint32_t side = 256;
    while (pages_across(side) * pages_across(side) < slots) side *= 2;
    return side;
}

gl::TextureSettings settings_of(std::uint32_t slots) {
    return {gl::TextureFormat::rgba8, gl::TextureFilter::linear, side_px(slots), side_px(slots)};
}

gl::TexelRect place_of(std::uint32_t slot, std::uint32_t side) {
    const std::uint32_t across = pages_across(side);
    return {slot % across * kDrapePosts, slot / across * kDrapePosts, kDrapePosts, kDrapePosts};
}

}  // namespace

std::uint64_t DrapeAtlas::bytes_needed(std::uint32_t slots) { return gl::texture_bytes(settings_of(slots)); }

base::Error DrapeAtlas::start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t slots) {
    TEDAVIS_CHECK(slots > 0);
    auto texture = gl::make_texture(gl, line, settings_of(slots));
    if (!texture.ok()) return texture.error();
    texture_ = static_cast<gl::Texture&&>(texture.value());
    const std::uint32_t corner = texture_.settings().width_px - kNowherePx;
    const std::uint8_t nothing[kNowherePx * kNowherePx * 4] = {};
    TEDAVIS_CHECK(texture_.upload(gl, {corner, corner, kNowherePx, kNowherePx}, nothing));
    return {};
}

bool DrapeAtlas::upload(gl::Gl& gl, std::uint32_t slot, const terrain::DrapePage& page) {
    return texture_.upload(gl, place_of(slot, texture_.settings().width_px), page.rgba);
}

DrapeOrigin DrapeAtlas::origin(std::uint32_t slot) const {
    const gl::TexelRect place = place_of(slot, texture_.settings().width_px);
    return {static_cast<float>(place.x) + 0.5f, static_cast<float>(place.y) + 0.5f};
}

DrapeOrigin DrapeAtlas::nowhere() const {
    const std::uint32_t middle_px = texture_.settings().width_px - kNowherePx / 2;
    return {static_cast<float>(middle_px), static_cast<float>(middle_px)};
}

float DrapeAtlas::scale() const { return 1.0f / static_cast<float>(texture_.settings().width_px); }

}  // namespace tedavis::draw
