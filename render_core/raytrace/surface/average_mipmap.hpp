/// Averages of the posts over squares of 2, 4, 8... posts, for surfaces that a pixel sees many posts of (thesis 6.2.2.2:
/// antialiasing by an average mipmap, trilinear by distance; Williams 1983).
///
/// Level 0 is the grid itself. A post of level n + 1 lies on every second one of level n and is their average with weights 1-2-1
/// both ways; posts without a height, and what lies beyond the border, weigh nothing. So cells of level n are the nodes of level
/// n of a HeightMipmap, whatever the size of the grid. Averages are rounded to Height: by half a step a level for std::int16_t.
///
/// What it changes: ridges and skylines sink, valleys rise. An averaged height lies between the lowest and highest post that it
/// was made from, but **not** below the highest post of its own cell: beside a peak it is above it. Rays need the bounds of
/// average_bounds(), which know all levels.
///
/// Memory  from an arena: Height times a third of the posts and a little. Thread  build() uses the workers; reading any.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/cell_bounds.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

template <class Height>
class AverageMipmap {
public:
    static constexpr std::uint32_t kMaxLevels = 17;

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows);
    /// False where the arena has no room. The grid is borrowed and must stay. Never more than `levels` and what the grid gives.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, base::Arena& arena, std::uint32_t levels = kMaxLevels);
    void build(base::Workers& workers);

    [[nodiscard]] std::uint32_t levels() const { return levels_; }
    [[nodiscard]] const HeightGrid<Height>& level(std::uint32_t n) const { return grids_[n]; }

    /// The surface as a pixel sees it that covers `footprint` posts there: between the two levels whose posts are that far apart,
    /// bilinear in each. Below 1 it is the bilinear surface of the posts. Where that has none (a void, outside the grid) false; a
    /// coarser level fills no hole.
    [[nodiscard]] bool find_surface(double x, double y, double footprint, SurfacePoint& point) const;

private:
    void average_row(std::uint32_t row);
    [[nodiscard]] SurfacePoint at_level(std::uint32_t n, double x, double y) const;

    HeightGrid<Height> grids_[kMaxLevels];
    base::Span<Height> posts_[kMaxLevels];
    std::uint32_t levels_ = 0;
    std::uint32_t in_work_ = 0;  ///< the level that build() is at
};

/// For a HeightMipmap over the same grid: bounds of the surface of all levels, so of every footprint. Borrows the pyramid, which
/// must be built.
template <class Height>
[[nodiscard]] CellBounds<Height> average_bounds(const AverageMipmap<Height>& averages);

}  // namespace tedavis::raytrace
