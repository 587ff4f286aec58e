#include "host_sim/flight_test/placed_words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

struct PlacedGlyph {
    const draw::Glyph* glyph = nullptr;  // null: none of the atlas
    draw::Point at;                      // its middle
    float em_px = 0;
    std::uint8_t rgb[3] = {};
    float right_em = 0, down_em = 0;  // of its middle, from the pen
};

const draw::Glyph* glyph_at(float x, float y) {
    for (const draw::Glyph& glyph : draw::font_atlas().glyphs)
        if (x > glyph.u && x < glyph.u + glyph.width && y > glyph.v && y < glyph.v + glyph.height) return &glyph;
    return nullptr;
}

constexpr float kGlyphItself = -1;  // extent_x of a QuadVertex: less for halos

/// Of the corners of a quad.
WrittenGlyph written_glyph(const draw::QuadVertex& a, const draw::QuadVertex& b, const draw::QuadVertex& d) {
    WrittenGlyph written;
    written.corner = {a.x, a.y};
    written.right = {b.x, b.y};
    written.down = {d.x, d.y};
    written.uv = {a.u, a.v};
    written.uv_right = {b.u, b.v};
    written.uv_down = {d.u, d.v};
    written.range_px = a.extent_y;
    written.color = {a.rgba[0], a.rgba[1], a.rgba[2], a.rgba[3]};
    return written;
}

/// The halos of a text are drawn before its characters, one for each.
class HaloCount {
public:
    void take_halo(float width_px) {
        if (is_taking_characters_) halos_ = 0;
        is_taking_characters_ = false;
        width_px_ = width_px;
        ++halos_;
    }
    float take_character() {
        is_taking_characters_ = true;
        if (halos_ == 0) return 0;
        --halos_;
        return width_px_;
    }

private:
    std::size_t halos_ = 0;
    float width_px_ = 0;
    bool is_taking_characters_ = false;
};

/// Of a quad's first and third corner. Nothing for a halo, which repeats its character.
std::optional<PlacedGlyph> placed_glyph(const draw::QuadVertex& a, const draw::QuadVertex& c) {
    if (a.extent_x != kGlyphItself) return std::nullopt;
    const draw::FontAtlas& atlas = draw::font_atlas();
    const float x = (a.u + c.u) / 2 * static_cast<float>(atlas.width), y = (a.v + c.v) / 2 * static_cast<float>(atlas.height);
    PlacedGlyph placed;
    placed.glyph = glyph_at(x, y);
    placed.at = {(a.x + c.x) / 2, (a.y + c.y) / 2};
    placed.em_px = a.extent_y / (2 * atlas.spread_em);
    std::copy(std::begin(a.rgba), std::begin(a.rgba) + 3, std::begin(placed.rgb));
    if (placed.glyph == nullptr) return placed;
    placed.right_em = (x - static_cast<float>(placed.glyph->u - placed.glyph->left)) / atlas.texels_per_em;
    placed.down_em = (y - static_cast<float>(placed.glyph->v - placed.glyph->top)) / atlas.texels_per_em;
    return placed;
}

/// Blanks between two characters, by how much farther apart they are than neighbors; nothing where they are not of one text.
std::optional<int> blanks_between(const PlacedGlyph& last, const PlacedGlyph& next) {
    constexpr float kMaxBlanks = 1;
    if (last.glyph == nullptr || next.glyph == nullptr || last.em_px != next.em_px || next.at.x <= last.at.x ||
        !std::equal(std::begin(last.rgb), std::end(last.rgb), std::begin(next.rgb)))
        return std::nullopt;
    const float neighbors_em = std::hypot(last.glyph->advance_em - last.right_em + next.right_em, next.down_em - last.down_em);
    const float apart_em = std::hypot(next.at.x - last.at.x, next.at.y - last.at.y) / last.em_px;
    const float blanks = std::round((apart_em - neighbors_em) / draw::glyph_of(' ').advance_em);
    return blanks <= kMaxBlanks ? std::optional<int>(blanks > 0 ? 1 : 0) : std::nullopt;
}

void append_code_point(std::uint32_t code_point, std::string& utf8) {
    const auto last_bits = [](std::uint32_t bits) { return static_cast<char>(0x80u | (bits & 0x3fu)); };
    if (code_point < 0x80)
        utf8 += static_cast<char>(code_point);
    else if (code_point < 0x800)
        utf8 += {static_cast<char>(0xc0u | code_point >> 6), last_bits(code_point)};
    else
        utf8 += {static_cast<char>(0xe0u | code_point >> 12), last_bits(code_point >> 6), last_bits(code_point)};
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
    HaloCount halos;
    const auto vertices = batch.vertices();
    const auto indices = batch.indices();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const draw::QuadVertex& a = vertices[indices[i]];
        const auto glyph = placed_glyph(a, vertices[indices[i + 2]]);
        const bool is_first_half = i + 5 < indices.size() && indices[i + 3] == indices[i];
        if (is_first_half && a.extent_x < kGlyphItself) halos.take_halo(-a.extent_x - 1);
        if (!is_first_half || a.extent_x >= 0) continue;
        WrittenGlyph written = written_glyph(a, vertices[indices[i + 1]], vertices[indices[i + 5]]);
        i += 3;  // a quad's second triangle begins with the first corner of its first one
        if (!glyph) continue;
        const std::optional<int> blanks = last ? blanks_between(*last, *glyph) : std::nullopt;
        if (!blanks) words.push_back({"", glyph->at.x, glyph->at.y, boxes_at(glyph->at, layout)});
        if (blanks.value_or(0) > 0) words.back().text += ' ';
        written.at = words.back().text.size();
        written.halo_px = halos.take_character();
        words.back().glyphs.push_back(written);
        append_code_point(glyph->glyph != nullptr ? glyph->glyph->code_point : '?', words.back().text);
        last = glyph;
    }
    return words;
}

std::vector<std::string> layout_box_names() {
    std::vector<std::string> names;
    for (const draw::LayoutBox& box : draw::kLayoutBoxes) names.emplace_back(box.name);
    return names;
}

std::string with_single_blanks(const std::string& text) {
    std::string kept;
    for (const char c : text)
        if (c != ' ' || (!kept.empty() && kept.back() != ' ')) kept += c;
    if (!kept.empty() && kept.back() == ' ') kept.pop_back();
    return kept;
}

std::vector<std::size_t> places_of_words(const std::string& text, const std::string& words) {
    std::vector<std::size_t> places;
    if (words.empty()) return places;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
        const std::size_t end = at + words.size();
        if ((at == 0 || text[at - 1] == ' ') && (end == text.size() || text[end] == ' ')) places.push_back(at);
    }
    return places;
}

bool has_words(const std::string& text, const std::string& words) { return !places_of_words(text, words).empty(); }

std::string unwritable_character(const std::string& text) {
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::string_view before = rest;
        const std::uint32_t code_point = draw::take_code_point(rest);
        if (draw::glyph_of(code_point).code_point != code_point)
            return std::string(before.substr(0, before.size() - rest.size()));
    }
    return {};
}

}  // namespace tedavis::host_sim
