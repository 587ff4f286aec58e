/// The maximum, or minimum, height of every cell of a grid, and of blocks of 2^k x 2^k cells (maximum mipmap: Tevs et al.
/// 2008).
///
/// Level 0 has one node per cell, each further level one per 2 x 2 nodes; sizes are rounded up, so that nodes at the right and
/// lower border cover the rest. A cell's bound covers its four posts and everything between them. A cell without a surface
/// counts as lower (for the minimum: higher) than all heights.
///
/// Memory  from an arena: sizeof(Height) times about 4/3 of the cells. Thread  build() and update() use the workers; reading
/// any.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/cell_bounds.hpp"

namespace tedavis::raytrace {

template <class Height>
struct MipmapLevel {
    const Height* nodes = nullptr;  ///< row by row; one element behind the last may be read
    std::uint32_t columns = 0, rows = 0;
    [[nodiscard]] Height at(std::uint32_t column, std::uint32_t row) const { return nodes[std::size_t{row} * columns + column]; }
};

/// The layout of the nodes of each level.
struct MipmapLayout {
    static constexpr int kMaxLevels = 16;
    std::int32_t top = 0;                 ///< the last level
    std::int32_t first[kMaxLevels] = {};  ///< node
    std::int32_t columns[kMaxLevels] = {}, rows[kMaxLevels] = {};
};

template <class Height>
class HeightMipmap {
public:
    explicit HeightMipmap(HeightBound bound = HeightBound::maximum) : bound_(bound) {}

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows);
    /// Allocates memory; returns false where the arena is too small. The grid must outlive the mipmap. Without `cells` bounds
    /// are those of each cell's four posts, which are valid for two triangles and bilinear surfaces only.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, base::Arena& arena, const CellBounds<Height>& cells = {});
    /// Computes all bounds.
    void build(base::Workers& workers);
    /// Updates the bounds after posts of a region have changed; the result equals that of build().
    void update(const PostRegion& changed);

    [[nodiscard]] const HeightGrid<Height>& grid() const { return grid_; }
    [[nodiscard]] HeightBound bound() const { return bound_; }
    [[nodiscard]] const MipmapLayout& layout() const { return layout_; }
    [[nodiscard]] std::uint32_t levels() const { return static_cast<std::uint32_t>(layout_.top) + 1; }
    [[nodiscard]] MipmapLevel<Height> level(std::uint32_t n) const;

private:
    [[nodiscard]] std::uint32_t across(int level) const { return static_cast<std::uint32_t>(layout_.columns[level]); }
    [[nodiscard]] std::uint32_t down(int level) const { return static_cast<std::uint32_t>(layout_.rows[level]); }
    [[nodiscard]] Height* row_of(int level, std::uint32_t row) const;
    void bound_row(int level, std::uint32_t row, std::uint32_t first, std::uint32_t end);
    void build_band(std::uint32_t band);

    HeightGrid<Height> grid_;
    HeightBound bound_;
    CellBounds<Height> cells_;
    MipmapLayout layout_;
    base::Span<Height> nodes_;
};

}  // namespace tedavis::raytrace
