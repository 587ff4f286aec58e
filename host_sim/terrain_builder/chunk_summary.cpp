#include "host_sim/terrain_builder/chunk_summary.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr std::uint8_t kHasHeights = kChunkHasSea | kChunkHasLand;

void include_heights(float least_m, float most_m, ChunkEntry& entry) {
    const bool first = (entry.flags & kHasHeights) == 0;
    entry.min_height_m = first ? least_m : std::min(entry.min_height_m, least_m);
    entry.max_height_m = first ? most_m : std::max(entry.max_height_m, most_m);
}

}  // namespace

void summarise_posts(const Lattice& lattice, const LatticeWindow& window, ChunkEntry& entry) {
    const PostRange posts = lattice.posts_of(key_of(entry));
    for (std::int64_t j = posts.j0; j <= posts.j1; ++j)
        for (std::int64_t i = posts.i0; i <= posts.i1; ++i) {
            const std::size_t n = window.at(i, j);
            if (window.post_class[n] == PostClass::void_) {
                entry.flags |= kChunkHasVoid;
                continue;
            }
            include_heights(window.height_m[n], window.height_m[n], entry);
            entry.flags |= window.post_class[n] == PostClass::sea ? kChunkHasSea : kChunkHasLand;
        }
}

void summarise_child(const ChunkEntry& child, ChunkEntry& entry) {
    entry.children = static_cast<std::uint8_t>(entry.children | (1u << key_of(child).quadrant()));
    if ((child.flags & kHasHeights) != 0) include_heights(child.min_height_m, child.max_height_m, entry);
    entry.flags = static_cast<std::uint8_t>(entry.flags | (child.flags & (kChunkHasVoid | kHasHeights)));
}

}  // namespace tedavis::host_sim
