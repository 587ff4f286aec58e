/// The cells of the picture that a batch of quads covers, for signs that must not overlap it.
///
/// A cell that a triangle touches is covered, antialiased edges included. Cells have the requested size, but at most kMaxCells
/// of them are across the picture. Thread  one. Memory  its own 2 KiB. Bounded by the batch and the cells.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/draw/quad_batch.hpp"

namespace tedavis::draw {

class ScreenCover {
public:
    static constexpr int kMaxCells = 128;

    /// Clears all cells.
    void clear(std::uint32_t width, std::uint32_t height, float cell_px);
    /// Adds a batch; `right_px` is its offset to the right in this picture.
    void take(const QuadBatch& batch, float right_px = 0);
    [[nodiscard]] bool is_free(const Rect& box) const;

private:
    using Row = std::array<std::uint64_t, 2>;  ///< a bit a cell

    [[nodiscard]] int cell_of(float px) const;
    [[nodiscard]] static Row span(int first, int last);
    void take_box(const Point& first, const Point& opposite);
    void take_triangle(const Point (&corner)[3]);
    void take_row(int row, float low, float high);

    float cell_px_ = 1;
    std::array<Row, kMaxCells> rows_{};
};

}  // namespace tedavis::draw
