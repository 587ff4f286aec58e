/// The texts of a quad batch as they are read: characters that follow each other in one size, closely.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/draw/drawn_shapes.hpp"

namespace tedavis::test_support {

struct DrawnWord {
    std::string text;
    std::vector<DrawnGlyph> glyphs;
};

/// Without blanks, in the order in which they were drawn. A character belongs to the word before it where it is of its size and
/// color and no farther from the last one than the width of a blank allows.
[[nodiscard]] inline std::vector<DrawnWord> drawn_words_of(const draw::QuadBatch& batch) {
    constexpr float kReach_em = 1.4f;  // between the middles of two wide letters with a blank between them
    std::vector<DrawnWord> words;
    for (const DrawnGlyph& glyph : drawn_shapes_of(batch).glyphs) {
        const bool goes_on = !words.empty() && [&] {
            const DrawnGlyph& last = words.back().glyphs.back();
            return is_same_color(last.color, glyph.color) && last.em_px == glyph.em_px &&
                   std::hypot(glyph.at.x - last.at.x, glyph.at.y - last.at.y) <= kReach_em * glyph.em_px &&
                   glyph.at.x > last.at.x;
        }();
        if (!goes_on) words.emplace_back();
        words.back().text += glyph.character;
        words.back().glyphs.push_back(glyph);
    }
    return words;
}

}  // namespace tedavis::test_support
