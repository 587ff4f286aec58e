/// The texts of a planned frame, read back from the triangles of its symbology.
#pragma once

#include <string>
#include <vector>

#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/layout.hpp"

namespace tedavis::host_sim {

/// The quad of a character as it is drawn (render_core/draw/quad_batch.hpp).
struct WrittenGlyph {
    std::size_t at = 0;                 ///< index of its first byte in the text
    draw::Point corner, right, down;    ///< pixels: the upper left corner of its quad, the upper right one, the lower left one
    draw::Point uv, uv_right, uv_down;  ///< coordinates of these corners in the font atlas, 0..1
    float range_px = 0;                 ///< distance over which the atlas rises from 0 to 1
    float halo_px = 0;                  ///< width of its halo; 0: it has none
    design::Color color;
};

struct PlacedWords {
    std::string text;                    ///< UTF-8, with single blanks: "TERRAIN AHEAD"
    float x = 0, y = 0;                  ///< centre of its first character, pixels from the picture's upper left
    std::vector<std::string> boxes;      ///< names of the layout's boxes that contain it, such as "annunciations"
    std::vector<WrittenGlyph> glyphs{};  ///< one for each character except blanks, in order
};

/// Returns the texts in the order in which they are drawn. Consecutive characters of one size and color with at most one blank
/// between them are one text.
[[nodiscard]] std::vector<PlacedWords> placed_words(const draw::QuadBatch& batch, const draw::Layout& layout);

/// Names of the boxes that a text can lie in.
[[nodiscard]] std::vector<std::string> layout_box_names();

/// Removes blanks at the ends and reduces those between words to one.
[[nodiscard]] std::string with_single_blanks(const std::string& text);
/// Returns the byte indices at which `words` occur in a text as whole words: "TERRAIN AHEAD" has "AHEAD", but not "HEAD" or "".
/// Both texts have single blanks.
[[nodiscard]] std::vector<std::size_t> places_of_words(const std::string& text, const std::string& words);
/// Whether places_of_words() finds any.
[[nodiscard]] bool has_words(const std::string& text, const std::string& words);
/// The first character that the typeface cannot write; empty where it can write all.
[[nodiscard]] std::string unwritable_character(const std::string& text);

}  // namespace tedavis::host_sim
