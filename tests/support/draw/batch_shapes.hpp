/// The shapes of a quad batch as tests ask for them: where something of a color lies, and what is written there.
#pragma once

#include <string>
#include <vector>

#include "render_core/draw/quad_batch.hpp"

namespace tedavis::test_support {

struct BatchShape {
    draw::Rect bounds;  ///< pixels; of boxes and lines without the pixel in which their edges fade out
    design::Color color;
    char letter = 0;      ///< of a glyph (ASCII), else 0
    bool is_rim = false;  ///< of a glyph: its dark halo

    [[nodiscard]] bool has(design::Color wanted) const {
        return color.red == wanted.red && color.green == wanted.green && color.blue == wanted.blue;
    }
};

/// In drawing order. Lines must be upright or level for their bounds to mean something.
[[nodiscard]] std::vector<BatchShape> shapes_of(const draw::QuadBatch& batch);

/// Those of the color that are no glyphs, or what is written in it, with their middle in `where`.
[[nodiscard]] std::vector<BatchShape> shapes_in(const draw::QuadBatch& batch, const draw::Rect& where, design::Color color);
[[nodiscard]] std::string text_in(const draw::QuadBatch& batch, const draw::Rect& where, design::Color color);

/// Box around all of them; empty for none.
[[nodiscard]] draw::Rect bounds_of(const std::vector<BatchShape>& shapes);

}  // namespace tedavis::test_support
