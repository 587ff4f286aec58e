#include "render_core/perception/edge_density.hpp"

#include <algorithm>

#include "render_core/perception/picture_view.hpp"

namespace tedavis::perception {

PixelRegion inner_region(int width, int height) noexcept { return {1, 1, std::max(width - 1, 1), std::max(height - 1, 1)}; }

PixelRegion region_of(const RegionGrid& grid, int column, int row, int width, int height) noexcept {
    const int across = std::max(width - 2, 0), down = std::max(height - 2, 0);
    return {1 + column * across / grid.columns, 1 + row * down / grid.rows, 1 + (column + 1) * across / grid.columns,
            1 + (row + 1) * down / grid.rows};
}

std::uint64_t count_edges(const EdgeView& picture, const PixelRegion& region) noexcept {
    std::uint64_t count = 0;
    const int left = std::clamp(region.left, 0, picture.width), right = std::clamp(region.right, left, picture.width);
    for (int y = std::max(region.top, 0); y < std::min(region.bottom, picture.height); ++y) {
        const std::uint8_t* row = picture.edges.data() + pixels_of(picture.width, y);
        std::uint32_t in_row = 0;
        for (int x = left; x < right; ++x) in_row += row[x] != 0 ? 1 : 0;
        count += in_row;
    }
    return count;
}

double edge_density(const EdgeView& picture, const PixelRegion& region) noexcept {
    const int across = region.right - region.left, down = region.bottom - region.top;
    if (across <= 0 || down <= 0) return 0;
    return static_cast<double>(count_edges(picture, region)) / static_cast<double>(pixels_of(across, down));
}

double edge_density(const EdgeView& picture) noexcept {
    return edge_density(picture, inner_region(picture.width, picture.height));
}

bool region_densities(const EdgeView& picture, const RegionGrid& grid, base::Span<double> densities) noexcept {
    if (!grid.is_valid() || densities.size() < static_cast<std::size_t>(grid.count())) return false;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            densities[pixels_of(grid.columns, row) + static_cast<std::size_t>(column)] =
                edge_density(picture, region_of(grid, column, row, picture.width, picture.height));
    return true;
}

}  // namespace tedavis::perception
