/// Places the entries of the key: cells of one size in one column, or in rows. Lengths with `_px` and rectangles are in pixels.
///
/// All cells together, with the gaps between them, take at most `kMaxKeyShare` of the picture. Cells that do not fit are counted.
/// Memory  none is allocated. Thread  any; the functions are pure. Failure  none.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/draw/rect.hpp"

namespace tedavis::draw {

inline constexpr float kMaxKeyShare = 0.05f;  ///< of the picture's area

/// The size of one entry: a title over a scale with its numbers, in text that can be read on every screen.
struct KeyCell {
    float em_px = 0;  ///< size of its text
    float width_px = 0, height_px = 0, gap_px = 0;
};
[[nodiscard]] KeyCell key_cell(float text_px) noexcept;

enum class KeyOrder : std::uint8_t { column, rows };

struct KeyPlan {
    KeyCell cell;
    Rect box;                        ///< all cells; empty without any
    std::size_t across = 1;          ///< cells in a row
    std::size_t shown = 0, cut = 0;  ///< cells that fit, and the others

    /// Returns the n-th of the shown cells, row by row from the upper left.
    [[nodiscard]] Rect cell_at(std::size_t n) const noexcept;
};
/// Plans `entries` cells within `room`, of a picture of `picture_px2` pixels: a column stands at the foot of the room, and rows
/// at its upper left corner.
[[nodiscard]] KeyPlan plan_key(const Rect& room, KeyOrder order, std::size_t entries, float picture_px2, float text_px) noexcept;

}  // namespace tedavis::draw
