#include "render_core/raytrace/ground/exact_posts.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::raytrace {
namespace {

using terrain::ChunkVertex;

/// A line of posts between two of a chunk's: which cell it crosses, and where.
struct AlongGrid {
    std::uint32_t cell = 0;  ///< the last post of the grid at or before it, but never the very last
    double share = 0;        ///< 0..1 of the cell
    bool is_end = false;     ///< of the lattice: no other chunk has a cell there

    static AlongGrid of(std::uint32_t post, std::uint32_t posts, std::uint32_t cells, std::uint32_t level, bool ends_there) {
        AlongGrid along;
        along.cell = std::min(post >> level, posts - 2);
        const std::uint32_t before = terrain::regular_post(along.cell, cells, level);
        const std::uint32_t behind = terrain::regular_post(along.cell + 1, cells, level);
        along.share = static_cast<double>(post - before) / (behind - before);
        along.is_end = ends_there && post == cells;
        return along;
    }
    /// Whether what lies at the cell's first (second) post matters.
    [[nodiscard]] bool needs(std::uint32_t which, bool is_between) const {
        if (share > 0 && share < 1) return true;
        return (is_end && is_between) || (share > 0) == (which == 1);
    }
    [[nodiscard]] bool is_between() const { return share > 0 && share < 1; }
};

struct ExactCell {
    const ChunkVertex* corner[4];  // north-west, north-east, south-west, south-east

    [[nodiscard]] bool is_void(const AlongGrid& i, const AlongGrid& j) const {
        for (std::uint32_t n = 0; n < 4; ++n)
            if (corner[n]->post_class() == terrain::PostClass::void_ && i.needs(n % 2, j.is_between()) &&
                j.needs(n / 2, i.is_between()))
                return true;
        return false;
    }
    [[nodiscard]] float height_m(double u, double v) const {
        const double nw = double{corner[0]->height_m}, ne = double{corner[1]->height_m};
        const double sw = double{corner[2]->height_m}, se = double{corner[3]->height_m};
        const double height = u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
        // No rounding leaves what the chunk's entry says of its heights.
        const double lowest = std::min(std::min(nw, ne), std::min(sw, se)),
                     highest = std::max(std::max(nw, ne), std::max(sw, se));
        return static_cast<float>(std::min(std::max(height, lowest), highest));
    }
};

template <class Height>
Height in_steps(float height_m, double step_m, GroundRounding& rounding) {
    if constexpr (sizeof(Height) == 4) {
        if (step_m == 1) return height_m;
        const auto height = static_cast<float>(double{height_m} / step_m);
        rounding.largest_m =
            std::max(rounding.largest_m, static_cast<float>(std::abs(double{height} * step_m - double{height_m})));
        return height;
    } else {
        const double steps = std::round(double{height_m} / step_m);
        if (!(std::abs(steps) <= 32767)) {
            rounding.has_beyond = true;
            return HeightGrid<Height>::kVoid;
        }
        // Whole where the product is the very float that is stored.
        const double height = steps * step_m;
        if (static_cast<float>(height) != height_m)
            rounding.largest_m = std::max(rounding.largest_m, static_cast<float>(std::abs(height - double{height_m})));
        return static_cast<Height>(steps);
    }
}

}  // namespace

template <class Height>
void put_exact_posts(const terrain::Lattice& lattice, const terrain::ChunkEntry& entry, base::Span<const ChunkVertex> vertices,
                     const GroundWindow<Height>& to, GroundRounding& rounding) {
    const terrain::PostRange posts = lattice.posts_of(terrain::key_of(entry));
    const std::uint32_t cells_i = posts.i1 - posts.i0, cells_j = posts.j1 - posts.j0, level = entry.level;
    const terrain::RegularGrid grid = terrain::regular_grid(cells_i, cells_j, level);
    const bool is_east = posts.i1 == lattice.columns() - 1, is_south = posts.j1 == lattice.rows() - 1;
    const std::uint32_t last_i = std::min(posts.i1, to.window.i1), last_j = std::min(posts.j1, to.window.j1);
    for (std::uint32_t j = std::max(posts.j0, to.window.j0); j <= last_j; ++j) {
        Height* const row = to.posts.data() + std::size_t{j - to.window.j0} * to.columns();
        const AlongGrid down = AlongGrid::of(j - posts.j0, grid.rows, cells_j, level, is_south);
        for (std::uint32_t i = std::max(posts.i0, to.window.i0); i <= last_i; ++i) {
            const AlongGrid across = AlongGrid::of(i - posts.i0, grid.columns, cells_i, level, is_east);
            ExactCell cell;
            for (std::uint32_t n = 0; n < 4; ++n)
                cell.corner[n] = &vertices[grid.index_of(across.cell + n % 2, down.cell + n / 2)];
            row[i - to.window.i0] = cell.is_void(across, down)
                                        ? HeightGrid<Height>::kVoid
                                        : in_steps<Height>(cell.height_m(across.share, down.share), to.step_m, rounding);
        }
    }
}

template void put_exact_posts(const terrain::Lattice&, const terrain::ChunkEntry&, base::Span<const ChunkVertex>,
                              const GroundWindow<std::int16_t>&, GroundRounding&);
template void put_exact_posts(const terrain::Lattice&, const terrain::ChunkEntry&, base::Span<const ChunkVertex>,
                              const GroundWindow<float>&, GroundRounding&);

}  // namespace tedavis::raytrace
