/// Averages of posts over squares of 2, 4, 8... posts, for surfaces of which a pixel covers many posts (thesis 6.2.2.2:
/// antialiasing by an average mipmap, trilinear by distance; Williams 1983).
///
/// Level 0 is the grid itself. A post of level n + 1 lies on every second post of level n and is the average there with weights
/// 1-2-1 in both directions; posts without a height, and posts outside the grid, have weight 0. So cells of level n coincide
/// with the nodes of level n of a HeightMipmap. Averages are rounded to Height: by up to half a step per level for
/// std::int16_t.
///
/// Effect: ridges and skylines sink, valleys rise. An averaged height lies between the lowest and highest of its posts, but may
/// be **above** the highest post of its own cell, beside a peak. Rays need the bounds of average_bounds(), which cover all
/// levels.
///
/// Memory  from an arena: sizeof(Height) times about a third of the posts. Thread  build() uses the workers; reading any.
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
    /// Allocates memory; returns false where the arena is too small. The grid must outlive the object. At most `levels` levels,
    /// fewer for a small grid.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, base::Arena& arena, std::uint32_t levels = kMaxLevels);
    void build(base::Workers& workers);

    [[nodiscard]] std::uint32_t levels() const { return levels_; }
    [[nodiscard]] const HeightGrid<Height>& level(std::uint32_t n) const { return grids_[n]; }

    /// Computes the surface for a pixel that covers `footprint` posts: interpolated between the two levels with about that
    /// spacing, bilinear in each. Below 1 it is the bilinear surface of the posts. Returns false where that has no surface (a
    /// void, outside the grid); coarser levels do not fill holes.
    [[nodiscard]] bool find_surface(double x, double y, double footprint, SurfacePoint& point) const;

private:
    void average_row(std::uint32_t row);
    [[nodiscard]] SurfacePoint at_level(std::uint32_t n, double x, double y) const;

    HeightGrid<Height> grids_[kMaxLevels];
    base::Span<Height> posts_[kMaxLevels];
    std::uint32_t levels_ = 0;
    std::uint32_t in_work_ = 0;  ///< level that build() is computing
};

/// Returns bounds of the surface of all levels, valid for every footprint, for a HeightMipmap over the same grid. The pyramid
/// must be built and outlive the bounds.
template <class Height>
[[nodiscard]] CellBounds<Height> average_bounds(const AverageMipmap<Height>& averages);

}  // namespace tedavis::raytrace
