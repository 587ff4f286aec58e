#include "render_core/draw/font_atlas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace tedavis::draw::test_font_atlas {
namespace {

TEST(FontAtlas, GlyphsAreSortedInsideTheAtlasAndDisjoint) {
    const FontAtlas& atlas = font_atlas();
    ASSERT_EQ(atlas.texels.size(), static_cast<std::size_t>(atlas.width) * atlas.height);
    for (std::size_t i = 0; i < atlas.glyphs.size(); ++i) {
        const Glyph& a = atlas.glyphs[i];
        EXPECT_LE(a.u + a.width, atlas.width);
        EXPECT_LE(a.v + a.height, atlas.height);
        for (std::size_t j = i + 1; j < atlas.glyphs.size(); ++j) {
            const Glyph& b = atlas.glyphs[j];
            EXPECT_LT(a.code_point, b.code_point);
            if (a.width == 0 || b.width == 0) continue;
            const bool apart = a.u + a.width <= b.u || b.u + b.width <= a.u || a.v + a.height <= b.v || b.v + b.height <= a.v;
            EXPECT_TRUE(apart) << a.code_point << " and " << b.code_point;
        }
    }
}

TEST(FontAtlas, HoldsAsciiAndTheSignsOfTheDisplay) {
    for (std::uint32_t c = 0x20; c < 0x7F; ++c) EXPECT_EQ(glyph_of(c).code_point, c);
    for (std::uint32_t c : {0xB0u, 0xB1u, 0x2190u, 0x2191u, 0x2192u, 0x2193u, 0x2212u}) EXPECT_EQ(glyph_of(c).code_point, c);
    EXPECT_EQ(glyph_of(0x4E2D).code_point, static_cast<std::uint32_t>('?'));
}

/// Whether a name is drawn as it is written; and its letters, each other than every other one.
TEST(FontAtlas, HoldsTheLettersOfWesternNames) {
    for (std::uint32_t c = 0xA0; c < 0x100; ++c) {
        if (c == 0xAD) continue;
        EXPECT_EQ(glyph_of(c).code_point, c) << "but for the soft hyphen";
    }
    for (std::uint32_t c : {0x152u, 0x153u, 0x160u, 0x161u, 0x178u}) EXPECT_EQ(glyph_of(c).code_point, c);
    for (const std::string name :
         {"Z\xC3\xBCrich", "Scuol/Schuls", "Saint-Moritz \xC3\xA9", "Gro\xC3\x9F-\xC3\x98sterbr\xC3\xB8"}) {
        std::string_view rest = name;
        while (!rest.empty()) {
            const std::uint32_t c = take_code_point(rest);
            EXPECT_EQ(glyph_of(c).code_point, c) << name;
        }
    }
    EXPECT_GT(glyph_of(0xC9).height, glyph_of('E').height) << "with an accent";
    EXPECT_EQ(glyph_of(0xC9).advance_em, glyph_of('E').advance_em);
    EXPECT_EQ(glyph_of(0x11B).code_point, static_cast<std::uint32_t>('?')) << "the typeface has none";
}

TEST(FontAtlas, DigitsAreOfOneWidthSoThatReadoutsStandStill) {
    for (char digit = '1'; digit <= '9'; ++digit) EXPECT_EQ(glyph_of(digit).advance_em, glyph_of('0').advance_em);
}

TEST(FontAtlas, EveryInkedGlyphReachesInsideAndIsOutsideAtItsBorder) {
    const FontAtlas& atlas = font_atlas();
    for (const Glyph& glyph : atlas.glyphs) {
        if (glyph.width == 0) continue;
        int highest = 0, border = 0;
        for (int y = 0; y < glyph.height; ++y)
            for (int x = 0; x < glyph.width; ++x) {
                const int texel = atlas.texels[static_cast<std::size_t>(glyph.v + y) * atlas.width + glyph.u + x];
                highest = std::max(highest, texel);
                if (x == 0 || y == 0 || x + 1 == glyph.width || y + 1 == glyph.height) border = std::max(border, texel);
            }
        EXPECT_GT(highest, 140) << glyph.code_point;
        EXPECT_LT(border, 40) << glyph.code_point;
    }
}

TEST(FontAtlas, DistancesAreOfSlopeOneAcrossAVerticalStem) {
    // The left edge of 'l' or 'I' is straight: neighbouring texels differ by one texel of distance.
    const FontAtlas& atlas = font_atlas();
    const Glyph& stem = glyph_of('I');
    const double texel_step = 255.0 / (2 * static_cast<double>(atlas.spread_em) * atlas.texels_per_em);
    const std::size_t row = static_cast<std::size_t>(stem.v + stem.height / 2) * atlas.width + stem.u;
    int steps = 0;
    for (int x = 0; x + 1 < stem.width / 2; ++x) {
        const int difference = atlas.texels[row + x + 1] - atlas.texels[row + x];
        if (atlas.texels[row + x] < 8 || atlas.texels[row + x + 1] > 128) continue;
        EXPECT_NEAR(difference, texel_step, 3);
        ++steps;
    }
    EXPECT_GE(steps, 2);
}

TEST(TakeCodePoint, ReadsUtf8AndCountsBrokenBytesOnce) {
    std::string_view text = "a\xC2\xB0\xE2\x86\x92\xF0\x9F\x98\x80";
    EXPECT_EQ(take_code_point(text), 'a');
    EXPECT_EQ(take_code_point(text), 0xB0u);
    EXPECT_EQ(take_code_point(text), 0x2192u);
    EXPECT_EQ(take_code_point(text), 0x1F600u);
    EXPECT_TRUE(text.empty());
    // Lone continuation, overlong, surrogate, beyond Unicode, cut.
    for (const std::string broken :
         {"\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x86", "\xFF"}) {
        std::string_view rest = broken;
        std::size_t taken = 0;
        for (; !rest.empty(); ++taken) EXPECT_EQ(take_code_point(rest), 0xFFFDu);
        EXPECT_EQ(taken, broken.size());
    }
}

TEST(TextWidth, AddsAdvancesAndScales) {
    EXPECT_EQ(text_width_px("", 20), 0);
    EXPECT_FLOAT_EQ(text_width_px("AB", 10), text_width_px("A", 10) + text_width_px("B", 10));
    EXPECT_FLOAT_EQ(text_width_px("1013 HPA", 40), 2 * text_width_px("1013 HPA", 20));
}

}  // namespace
}  // namespace tedavis::draw::test_font_atlas
