/// The texts of a planned frame, read back from the triangles of its symbology.
#pragma once

#include <string>
#include <vector>

#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/layout.hpp"

namespace tedavis::host_sim {

/// A character's quad, as it is drawn (render_core/draw/quad_batch.hpp).
struct WrittenGlyph {
    std::size_t at = 0;                 ///< its first byte in the text
    draw::Point corner, right, down;    ///< pixels: the upper left corner of its quad, the upper right one, the lower left one
    draw::Point uv, uv_right, uv_down;  ///< in the font atlas, 0..1, of the same corners
    float range_px = 0;                 ///< pixels between the atlas's values 0 and 1
    float halo_px = 0;                  ///< width of its rim; 0: it has none
    design::Color color;
};

struct PlacedWords {
    std::string text;                    ///< UTF-8, with single blanks: "TERRAIN AHEAD"
    float x = 0, y = 0;                  ///< pixels from the upper left: its first character's middle
    std::vector<std::string> boxes;      ///< of the layout that it lies in, such as "annunciations"
    std::vector<WrittenGlyph> glyphs{};  ///< of its characters, in their order; blanks have none
};

/// In the order in which they are drawn. Characters of one size and color that follow each other with at most
/// one blank between them are one text.
[[nodiscard]] std::vector<PlacedWords> placed_words(const draw::QuadBatch& batch, const draw::Layout& layout);

/// Names of the boxes that a text can lie in.
[[nodiscard]] std::vector<std::string> layout_box_names();

/// Without blanks at its ends, and with one between words.
[[nodiscard]] std::string with_single_blanks(const std::string& text);
/// The bytes at which a text has these words whole: "TERRAIN AHEAD" has "AHEAD", but not "HEAD" or "". Both have single blanks.
[[nodiscard]] std::vector<std::size_t> places_of_words(const std::string& text, const std::string& words);
/// Whether there is such a place.
[[nodiscard]] bool has_words(const std::string& text, const std::string& words);
/// The first character that the typeface cannot write; empty where it can write all.
[[nodiscard]] std::string unwritable_character(const std::string& text);

}  // namespace tedavis::host_sim
