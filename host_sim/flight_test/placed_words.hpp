/// The texts of a planned frame, read back from the triangles of its symbology.
#pragma once

#include <string>
#include <vector>

#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/layout.hpp"

namespace tedavis::host_sim {

struct PlacedWords {
    std::string text;                ///< without blanks: "TERRAINAHEAD"
    float x = 0, y = 0;              ///< pixels from the upper left: its first character's middle
    std::vector<std::string> boxes;  ///< of the layout that it lies in, such as "annunciations"
};

/// In the order in which they are drawn. Characters of one size and color that follow each other closely are one text.
[[nodiscard]] std::vector<PlacedWords> placed_words(const draw::QuadBatch& batch, const draw::Layout& layout);

/// Names of the boxes that a text can lie in.
[[nodiscard]] std::vector<std::string> layout_box_names();
[[nodiscard]] std::string without_blanks(const std::string& text);

}  // namespace tedavis::host_sim
