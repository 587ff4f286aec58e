/// The texts of a planned frame, read back from the triangles of its symbology.
#pragma once

#include <string>
#include <vector>

#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/layout.hpp"

namespace tedavis::host_sim {

struct PlacedWords {
    std::string text;                ///< UTF-8, with single blanks: "TERRAIN AHEAD"
    float x = 0, y = 0;              ///< pixels from the upper left: its first character's middle
    std::vector<std::string> boxes;  ///< of the layout that it lies in, such as "annunciations"
};

/// In the order in which they are drawn. Characters of one size and color that follow each other with at most
/// one blank between them are one text.
[[nodiscard]] std::vector<PlacedWords> placed_words(const draw::QuadBatch& batch, const draw::Layout& layout);

/// Names of the boxes that a text can lie in.
[[nodiscard]] std::vector<std::string> layout_box_names();

/// Without blanks at its ends, and with one between words.
[[nodiscard]] std::string with_single_blanks(const std::string& text);
/// Whether a text has these words whole: "TERRAIN AHEAD" has "AHEAD", but not "HEAD" or "". Both have single blanks.
[[nodiscard]] bool has_words(const std::string& text, const std::string& words);
/// The first character that the typeface cannot write; empty where it can write all.
[[nodiscard]] std::string unwritable_character(const std::string& text);

}  // namespace tedavis::host_sim
