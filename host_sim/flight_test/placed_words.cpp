#include "host_sim/flight_test/placed_words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

struct PlacedGlyph {
    char character = 0;
    draw::Point at;
    float em_px = 0;
    std::uint8_t rgb[3] = {};
};

char character_at(float u, float v) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    const float x = u * static_cast<float>(atlas.width), y = v * static_cast<float>(atlas.height);
    for (const draw::Glyph& glyph : atlas.glyphs)
        if (x > glyph.u && x < glyph.u + glyph.width && y > glyph.v && y < glyph.v + glyph.height)
            return glyph.code_point < 128 ? static_cast<char>(glyph.code_point) : '?';
    return '?';
}

/// Of a quad's first and third corner. Nothing for a halo, which repeats its character.
std::optional<PlacedGlyph> glyph_of(const draw::QuadVertex& a, const draw::QuadVertex& c) {
    constexpr float kGlyphItself = -1;  // QuadBatch: less for halos
    if (a.extent_x != kGlyphItself) return std::nullopt;
    const float em_px = a.extent_y / (2 * draw::font_atlas().spread_em);
    return PlacedGlyph{character_at((a.u + c.u) / 2, (a.v + c.v) / 2),
                       {(a.x + c.x) / 2, (a.y + c.y) / 2},
                       em_px,
                       {a.rgba[0], a.rgba[1], a.rgba[2]}};
}

bool goes_on(const PlacedGlyph& last, const PlacedGlyph& next) {
    constexpr float kReach_em = 1.4f;  // between the middles of two wide letters with a blank between them
    return std::equal(std::begin(last.rgb), std::end(last.rgb), std::begin(next.rgb)) && last.em_px == next.em_px &&
           next.at.x > last.at.x && std::hypot(next.at.x - last.at.x, next.at.y - last.at.y) <= kReach_em * next.em_px;
}

std::vector<std::string> boxes_at(draw::Point at, const draw::Layout& layout) {
    std::vector<std::string> names;
    for (const draw::LayoutBox& box : draw::kLayoutBoxes)
        if ((layout.*box.box).contains(at)) names.emplace_back(box.name);
    return names;
}

}  // namespace

std::vector<PlacedWords> placed_words(const draw::QuadBatch& batch, const draw::Layout& layout) {
    std::vector<PlacedWords> words;
    std::optional<PlacedGlyph> last;
    const auto vertices = batch.vertices();
    const auto indices = batch.indices();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto glyph = glyph_of(vertices[indices[i]], vertices[indices[i + 2]]);
        const bool is_first_half = i + 5 < indices.size() && indices[i + 3] == indices[i];
        if (!glyph || !is_first_half) continue;
        i += 3;  // a quad's second triangle begins with the first corner of its first one
        if (!last || !goes_on(*last, *glyph)) words.push_back({"", glyph->at.x, glyph->at.y, boxes_at(glyph->at, layout)});
        words.back().text += glyph->character;
        last = glyph;
    }
    return words;
}

std::vector<std::string> layout_box_names() {
    std::vector<std::string> names;
    for (const draw::LayoutBox& box : draw::kLayoutBoxes) names.emplace_back(box.name);
    return names;
}

std::string without_blanks(const std::string& text) {
    std::string kept;
    std::copy_if(text.begin(), text.end(), std::back_inserter(kept), [](char c) { return c != ' '; });
    return kept;
}

}  // namespace tedavis::host_sim
