/// The degree of visual clutter: the share of a picture's pixels that are edges, 0..1 (thesis, 5.3.2), as a whole and by regions.
///
/// A picture's outermost pixels do not count, because their gradient uses pixels outside the picture. Regions are the cells of
/// a grid over the rest, as equal as whole pixels allow; a region without a pixel has the density 0. Counts are integers, so
/// counts of parts add up to that of the whole.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"

namespace tedavis::perception {

struct RegionGrid {
    static constexpr int kMax = 64;
    int columns = 8, rows = 6;  ///< 1..kMax
    [[nodiscard]] bool is_valid() const { return columns >= 1 && rows >= 1 && columns <= kMax && rows <= kMax; }
    [[nodiscard]] int count() const { return columns * rows; }
};

/// Pixels from (left, top) up to, but not at, (right, bottom).
struct PixelRegion {
    int left = 0, top = 0, right = 0, bottom = 0;
};
/// Returns the pixels of a grid's cell; column and row count from the upper left.
[[nodiscard]] PixelRegion region_of(const RegionGrid& grid, int column, int row, int width, int height) noexcept;
/// Returns the pixels of a picture that count.
[[nodiscard]] PixelRegion inner_region(int width, int height) noexcept;

/// An edge map: one byte per pixel, not 0 for edges, rows from the top without gaps.
struct EdgeView {
    base::Span<const std::uint8_t> edges;
    int width = 0, height = 0;
};
[[nodiscard]] std::uint64_t count_edges(const EdgeView& picture, const PixelRegion& region) noexcept;
[[nodiscard]] double edge_density(const EdgeView& picture, const PixelRegion& region) noexcept;
/// Returns the density of the whole picture.
[[nodiscard]] double edge_density(const EdgeView& picture) noexcept;
/// Writes the density of each region, row by row from the upper left. Returns false, and writes nothing, where the grid is not
/// valid or `densities` is too short.
[[nodiscard]] bool region_densities(const EdgeView& picture, const RegionGrid& grid, base::Span<double> densities) noexcept;

}  // namespace tedavis::perception
