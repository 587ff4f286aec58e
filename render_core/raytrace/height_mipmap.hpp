/// The highest, or lowest, height of every cell of a grid, and of blocks of 2^k x 2^k cells (maximum mipmap: Tevs et al. 2008).
///
/// Level 0 has a node a cell, each further level one for 2 x 2 nodes, those at the right and lower border for fewer: no size
/// loses a row, as halving with rounding down would. A cell lies between four posts, so neighbours share posts and bounds hold
/// for everything between them. A cell without a surface bounds nothing; it counts as lower (for the minimum: higher) than all.
///
/// Memory  from an arena: Height times 4/3 of the cells and a little. Thread  build() and update() use the workers; reading any.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/cell_bounds.hpp"

namespace tedavis::raytrace {

template <class Height>
struct MipmapLevel {
    const Height* nodes = nullptr;  ///< row by row; one more may be read behind the last
    std::uint32_t columns = 0, rows = 0;
    [[nodiscard]] Height at(std::uint32_t column, std::uint32_t row) const { return nodes[std::size_t{row} * columns + column]; }
};

/// Where the nodes of each level lie.
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
    /// False where the arena has no room. The grid is borrowed and must stay. Without `cells` bounds are those of each cell's
    /// four posts, which hold for two triangles and for bilinear surfaces, and for no other.
    [[nodiscard]] bool start(const HeightGrid<Height>& grid, base::Arena& arena, const CellBounds<Height>& cells = {});
    /// Of all posts.
    void build(base::Workers& workers);
    /// After posts of a region have changed; gives what build() would.
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
