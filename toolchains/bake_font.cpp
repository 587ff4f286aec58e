/// Bakes an outline font into a signed-distance atlas; run by hand when the font or the set of glyphs changes, its two
/// products are committed so that no build needs the font or this tool:
///
///   c++ -std=c++17 -O2 toolchains/bake_font.cpp -o build/bake_font          (Debian: libstb-dev fonts-b612)
///   build/bake_font /usr/share/fonts/opentype/b612/B612-Bold.otf render_core/draw/font
///
/// writes b612_atlas.bin (one byte a texel, top row first) and b612_glyphs.hpp (its measures). A texel holds
/// 0.5 + distance / (2 * spread), distance in ems, positive inside the outline. The distance is taken to the nearest
/// sample of the other side on a grid of kOversampling samples a texel, since stb's own distance field ignores the
/// cubic curves of OpenType outlines.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr int kTexelsPerEm = 32;
constexpr int kOversampling = 16;
constexpr int kSpreadTexels = 4;
constexpr int kWidth = 512;
constexpr int kHeight = 512;

struct Mask {
    int left = 0, top = 0, width = 0, height = 0;  // samples; left and top relative to the pen on the baseline, y down
    std::vector<unsigned char> inside;

    [[nodiscard]] bool at(int x, int y) const {
        const int column = x - left, row = y - top;
        if (column < 0 || row < 0 || column >= width || row >= height) return false;
        return inside[static_cast<std::size_t>(row) * width + column] >= 128;
    }
};

struct Placed {
    unsigned code_point = 0;
    double advance_em = 0;
    int left = 0, top = 0, width = 0, height = 0;  // texels, with the spread around
    int u = 0, v = 0;
};

Mask rasterized(const stbtt_fontinfo& font, int glyph) {
    const float scale = stbtt_ScaleForMappingEmToPixels(&font, static_cast<float>(kTexelsPerEm * kOversampling));
    Mask mask;
    int right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBox(&font, glyph, scale, scale, &mask.left, &mask.top, &right, &bottom);
    mask.width = right - mask.left;
    mask.height = bottom - mask.top;
    mask.inside.resize(static_cast<std::size_t>(mask.width) * mask.height);
    if (!mask.inside.empty())
        stbtt_MakeGlyphBitmap(&font, mask.inside.data(), mask.width, mask.height, mask.width, scale, scale, glyph);
    return mask;
}

unsigned char distance_texel(const Mask& mask, int center_x, int center_y) {
    const int reach = kSpreadTexels * kOversampling;
    const bool inside = mask.at(center_x, center_y);
    int nearest = reach * reach;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const int squared = dx * dx + dy * dy;
            if (squared < nearest && mask.at(center_x + dx, center_y + dy) != inside) nearest = squared;
        }
    const double distance = (std::sqrt(static_cast<double>(nearest)) - 0.5) / reach * (inside ? 1 : -1);
    return static_cast<unsigned char>(std::clamp(std::lround(127.5 + 127.5 * distance), 0L, 255L));
}

int floor_div(int value, int divisor) { return static_cast<int>(std::floor(static_cast<double>(value) / divisor)); }

void draw(const Mask& mask, const Placed& placed, std::vector<unsigned char>& atlas) {
    for (int row = 0; row < placed.height; ++row)
        for (int column = 0; column < placed.width; ++column)
            atlas[static_cast<std::size_t>(placed.v + row) * kWidth + placed.u + column] =
                distance_texel(mask, (placed.left + column) * kOversampling + kOversampling / 2,
                               (placed.top + row) * kOversampling + kOversampling / 2);
}

std::vector<unsigned> code_points() {
    std::vector<unsigned> all;
    for (unsigned c = 0x20; c < 0x7f; ++c) all.push_back(c);
    for (unsigned c = 0xa0; c < 0x180; ++c)  // Latin-1 and Latin Extended-A
        if (c != 0xad) all.push_back(c);
    for (unsigned c : {0x2013u, 0x2190u, 0x2191u, 0x2192u, 0x2193u, 0x2212u}) all.push_back(c);
    return all;
}

struct Baked {
    Placed placed;
    Mask mask;
};

Baked baked(const stbtt_fontinfo& font, unsigned code_point, int glyph) {
    Baked one;
    Placed& placed = one.placed;
    placed.code_point = code_point;
    int advance = 0, bearing = 0;
    stbtt_GetGlyphHMetrics(&font, glyph, &advance, &bearing);
    placed.advance_em = advance * static_cast<double>(stbtt_ScaleForMappingEmToPixels(&font, 1.0f));
    one.mask = rasterized(font, glyph);
    if (one.mask.width == 0) return one;
    placed.left = floor_div(one.mask.left, kOversampling) - kSpreadTexels;
    placed.top = floor_div(one.mask.top, kOversampling) - kSpreadTexels;
    placed.width = floor_div(one.mask.left + one.mask.width - 1, kOversampling) + kSpreadTexels + 1 - placed.left;
    placed.height = floor_div(one.mask.top + one.mask.height - 1, kOversampling) + kSpreadTexels + 1 - placed.top;
    return one;
}

/// On shelves, the highest first.
bool place(std::vector<Baked>& glyphs) {
    std::vector<Baked*> by_height;
    for (Baked& one : glyphs) by_height.push_back(&one);
    std::stable_sort(by_height.begin(), by_height.end(),
                     [](const Baked* a, const Baked* b) { return a->placed.height > b->placed.height; });
    int u = 0, v = 0, shelf = 0;
    for (Baked* one : by_height) {
        Placed& placed = one->placed;
        if (placed.width == 0) continue;
        if (u + placed.width > kWidth) u = 0, v += shelf, shelf = 0;
        if (v + placed.height > kHeight) return false;
        placed.u = u;
        placed.v = v;
        u += placed.width;
        shelf = std::max(shelf, placed.height);
    }
    std::printf("%d of %d rows\n", v + shelf, kHeight);
    return true;
}

bool bake(const stbtt_fontinfo& font, std::vector<Placed>& placed, std::vector<unsigned char>& atlas) {
    std::vector<Baked> glyphs;
    for (unsigned code_point : code_points())
        if (const int glyph = stbtt_FindGlyphIndex(&font, static_cast<int>(code_point)); glyph != 0)
            glyphs.push_back(baked(font, code_point, glyph));
    if (!place(glyphs)) return false;
    for (const Baked& one : glyphs) {
        draw(one.mask, one.placed, atlas);
        placed.push_back(one.placed);
    }
    return true;
}

std::string glyph_header(const stbtt_fontinfo& font, const std::vector<Placed>& placed) {
    int x0 = 0, y0 = 0, x1 = 0, cap = 0;
    stbtt_GetCodepointBox(&font, 'H', &x0, &y0, &x1, &cap);
    char line[160];
    std::string text =
        "// Generated by toolchains/bake_font.cpp; do not edit. B612: SIL Open Font License 1.1, see LICENSE.B612 beside.\n"
        "#pragma once\n\n// clang-format off\n#include \"render_core/draw/font_atlas.hpp\"\n\nnamespace tedavis::draw::b612 "
        "{\n\n";
    std::snprintf(line, sizeof line, "inline constexpr int kWidth = %d;\ninline constexpr int kHeight = %d;\n", kWidth, kHeight);
    text += line;
    std::snprintf(line, sizeof line, "inline constexpr float kTexelsPerEm = %d;\ninline constexpr float kSpread_em = %.6ff;\n",
                  kTexelsPerEm, static_cast<double>(kSpreadTexels) / kTexelsPerEm);
    text += line;
    std::snprintf(line, sizeof line, "inline constexpr float kCapHeight_em = %.6ff;\n\n",
                  cap * static_cast<double>(stbtt_ScaleForMappingEmToPixels(&font, 1.0f)));
    text += line;
    text += "/// Code point, advance in ems; left, top, width, height in texels from the pen, y down; place in the atlas.\n";
    text += "inline constexpr Glyph kGlyphs[] = {\n";
    for (const Placed& p : placed) {
        std::snprintf(line, sizeof line, "    {0x%04x, %.6ff, %d, %d, %d, %d, %d, %d},\n", p.code_point, p.advance_em, p.left,
                      p.top, p.width, p.height, p.u, p.v);
        text += line;
    }
    return text + "};\n\n}  // namespace tedavis::draw::b612\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: bake_font FONT.otf FOLDER\n");
        return 2;
    }
    std::ifstream file(argv[1], std::ios::binary);
    const std::vector<unsigned char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    stbtt_fontinfo font;
    if (bytes.empty() || stbtt_InitFont(&font, bytes.data(), stbtt_GetFontOffsetForIndex(bytes.data(), 0)) == 0) {
        std::fprintf(stderr, "%s: not a readable OpenType font; install fonts-b612\n", argv[1]);
        return 2;
    }
    std::vector<Placed> placed;
    std::vector<unsigned char> atlas(static_cast<std::size_t>(kWidth) * kHeight, 0);
    if (!bake(font, placed, atlas)) {
        std::fprintf(stderr, "the glyphs do not fit %d x %d texels; enlarge the atlas in bake_font.cpp\n", kWidth, kHeight);
        return 1;
    }
    const std::string folder = argv[2];
    std::ofstream(folder + "/b612_atlas.bin", std::ios::binary)
        .write(reinterpret_cast<const char*>(atlas.data()), static_cast<std::streamsize>(atlas.size()));
    std::ofstream(folder + "/b612_glyphs.hpp") << glyph_header(font, placed);
    std::printf("%zu glyphs\n", placed.size());
    return 0;
}
