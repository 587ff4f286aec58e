#include "render_core/terrain/block_extents.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace tedavis::terrain {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr BlockExtents::Extent kNothing{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
/// Axes are floats: they are this far from unit length and right angles, and what is said along them from what it stands for.
constexpr double kAxisError = 2e-6;

glm::dvec3 axis_of(const ChunkEntry& entry, int axis) {
    return {entry.axes[3 * axis], entry.axes[3 * axis + 1], entry.axes[3 * axis + 2]};
}

void include(BlockExtents::Extent& extent, const double (&along)[3]) {
    for (int axis = 0; axis < 3; ++axis) {
        extent.low[axis] = std::min(extent.low[axis], std::nextafter(static_cast<float>(along[axis]), -kFar));
        extent.high[axis] = std::max(extent.high[axis], std::nextafter(static_cast<float>(along[axis]), kFar));
    }
}

/// Neighbours share the posts between them.
void include_in_blocks(BlockExtents& extents, std::uint32_t a, std::uint32_t b, const double (&along)[3]) {
    constexpr std::uint32_t kCells = BlockExtents::kCells, kSide = BlockExtents::kSide;
    const std::uint32_t first_a = a == 0 ? 0 : (a - 1) / kCells, last_a = std::min(a / kCells, kSide - 1);
    const std::uint32_t first_b = b == 0 ? 0 : (b - 1) / kCells, last_b = std::min(b / kCells, kSide - 1);
    for (std::uint32_t j = first_b; j <= last_b; ++j)
        for (std::uint32_t i = first_a; i <= last_a; ++i) include(extents.blocks[j * kSide + i], along);
}

}  // namespace

BlockExtents block_extents(const ChunkEntry& entry, const RegularGrid& grid, base::Span<const ChunkVertex> vertices) {
    BlockExtents extents;
    std::fill(std::begin(extents.blocks), std::end(extents.blocks), kNothing);
    const glm::dvec3 axes[] = {axis_of(entry, 0), axis_of(entry, 1), axis_of(entry, 2)};
    for (std::uint32_t b = 0; b < grid.rows; ++b)
        for (std::uint32_t a = 0; a < grid.columns; ++a) {
            const ChunkVertex& vertex = vertices[grid.index_of(a, b)];
            const glm::dvec3 place(double{vertex.x}, double{vertex.y}, double{vertex.z});
            include_in_blocks(extents, a, b, {glm::dot(place, axes[0]), glm::dot(place, axes[1]), glm::dot(place, axes[2])});
        }
    return extents;
}

ViewBox seen_block(const ChunkEntry& entry, const BlockExtents::Extent& block, const View& view) {
    ViewBox box;
    if (!(block.low[0] <= block.high[0])) return box;
    glm::dvec3 middle = glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - view.eye, reach(0);
    double farthest_m = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = double{block.low[axis]}, high = double{block.high[axis]};
        middle += axis_of(entry, axis) * (0.5 * (low + high));
        reach += glm::abs(seen(view, axis_of(entry, axis))) * (0.5 * (high - low));
        farthest_m += std::max(-low, high);
    }
    middle = seen(view, middle);
    reach += kAxisError * farthest_m;
    box.low = middle - reach;
    box.high = middle + reach;
    return box;
}

}  // namespace tedavis::terrain
