#include "host_sim/terrain_builder/inset_coverage.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

using namespace terrain;

/// Outwards to multiples of `cells`, within the lattice.
PostRange aligned(const PostRange& posts, std::uint32_t margin, std::uint32_t cells, const Lattice& lattice) {
    const auto down = [&](std::uint32_t post) { return (post > margin ? post - margin : 0) / cells * cells; };
    const auto up = [&](std::uint32_t post, std::uint32_t last) {
        return std::min((post + margin + cells - 1) / cells * cells, last);
    };
    return {down(posts.i0), down(posts.j0), up(posts.i1, lattice.columns() - 1), up(posts.j1, lattice.rows() - 1)};
}

bool holds(const PostRange& outer, const PostRange& inner) {
    return outer.i0 <= inner.i0 && outer.j0 <= inner.j0 && outer.i1 >= inner.i1 && outer.j1 >= inner.j1;
}

bool touch(const PostRange& a, const PostRange& b) { return a.i0 <= b.i1 && b.i0 <= a.i1 && a.j0 <= b.j1 && b.j0 <= a.j1; }

PostRange joined(const PostRange& a, const PostRange& b) {
    return {std::min(a.i0, b.i0), std::min(a.j0, b.j0), std::max(a.i1, b.i1), std::max(a.j1, b.j1)};
}

/// Rectangles that touch become one.
std::vector<PostRange> separated(std::vector<PostRange> all) {
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            if (!touch(all[a], all[b])) continue;
            all[a] = joined(all[a], all[b]);
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(b));
            a = b = 0;  // the larger one may touch those that were passed
        }
    return all;
}

}  // namespace

InsetCoverage::InsetCoverage(const Lattice& lattice, std::uint32_t base_level, const std::vector<PostRange>& footprints)
    : lattice_(lattice), base_level_(base_level), refined_(base_level) {
    for (const PostRange& footprint : footprints) {
        // At its rim an inset has no weight: where a level ends, posts are the coarse surface's alone.
        PostRange posts = aligned(footprint, 0, kChunkCells << 1, lattice);
        refined_[0].push_back(posts);
        for (std::uint32_t level = 1; level < base_level; ++level) {
            // A ring of the level's own chunks, then whole families.
            posts = aligned(posts, kChunkCells << level, kChunkCells << (level + 1), lattice);
            refined_[level].push_back(posts);
        }
    }
    regions_ = separated(refined_[base_level - 1]);
}

bool InsetCoverage::is_refined(std::uint32_t level, const PostRange& posts) const {
    return std::any_of(refined_[level].begin(), refined_[level].end(), [&](const PostRange& r) { return holds(r, posts); });
}

bool InsetCoverage::exists(const ChunkKey& key) const {
    return key.level >= base_level_ || is_refined(key.level, lattice_.posts_of(key));
}

bool InsetCoverage::has_children(const ChunkKey& key) const {
    if (key.level == 0) return false;
    return key.level > base_level_ || is_refined(key.level - 1, lattice_.posts_of(key));
}

}  // namespace tedavis::host_sim
