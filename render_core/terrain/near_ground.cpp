#include "render_core/terrain/near_ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/terrain/block_extents.hpp"
#include "render_core/terrain/ground_scan.hpp"
#include "render_core/terrain/projected_error.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::terrain {
namespace {

constexpr double kFirstMargin_m = 0.05, kMarginRatio = 2;
constexpr std::uint32_t kMaxLooks = 256;  // at chunks with children, for one margin
constexpr std::uint32_t kMaxChunks = HeightQuery::kKeptChunks - 1;
constexpr double kBeside = 0.5;  // of a chunk's half side: from so close its vertices are looked at
constexpr std::uint32_t kBlockCells = 4, kBlocks = kChunkCells / kBlockCells;
constexpr std::uint32_t kGroupBlocks = BlockExtents::kCells / kBlockCells, kGroups = BlockExtents::kSide;  // looked at first

bool is_finite(const View& view) {
    return std::isfinite(glm::dot(view.eye, view.eye) + glm::dot(view.forward, view.forward) + glm::dot(view.right, view.right) +
                         glm::dot(view.down, view.down) + view.focal_px + view.near_m);
}

/// Of all that is drawn no farther than the margin above or below the surface in a chunk's box.
double px_per_m_in_box(const ChunkEntry& entry, const View& view, double margin_m) {
    constexpr double kFloats = 1e-6;  // half extents are rounded to them
    ChunkEntry reached = entry;
    for (float& half_m : reached.half_extent_m) half_m = static_cast<float>((double{half_m} + margin_m) * (1 + kFloats));
    return is_outside_view(reached, view) ? 0 : error_in_box_px(reached, view, margin_m, 0) / margin_m;
}

/// The vertices of an exact chunk.
class ChunkPosts {
public:
    ChunkPosts(const Lattice& lattice, const ExactChunk& chunk, const View& view)
        : grid_(grid_of(lattice.posts_of(key_of(*chunk.entry)), chunk.entry->level)),
          vertices_(chunk.vertices),
          centre_(glm::dvec3(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]) - view.eye),
          view_(view) {}

    [[nodiscard]] std::uint32_t columns() const { return grid_.columns; }
    [[nodiscard]] std::uint32_t rows() const { return grid_.rows; }
    [[nodiscard]] bool is_void(std::uint32_t a, std::uint32_t b) const {
        return vertices_[grid_.index_of(a, b)].post_class() == PostClass::void_;
    }
    [[nodiscard]] glm::dvec3 place(std::uint32_t a, std::uint32_t b) const {
        const ChunkVertex& v = vertices_[grid_.index_of(a, b)];
        return seen(view_, centre_ + glm::dvec3(double{v.x}, double{v.y}, double{v.z}));
    }

private:
    static RegularGrid grid_of(const PostRange& posts, std::uint32_t level) {
        return regular_grid(posts.i1 - posts.i0, posts.j1 - posts.j0, level);
    }

    const RegularGrid grid_;
    const base::Span<const ChunkVertex> vertices_;
    const glm::dvec3 centre_;  ///< relative to the eye
    const View& view_;
};

/// Cells of a block: its first ones, and the ones after its last.
struct Block {
    std::uint32_t a0, b0, a1, b1;
};

Block block_of(const ChunkPosts& posts, std::uint32_t number) {
    const std::uint32_t a = number % kBlocks * kBlockCells, b = number / kBlocks * kBlockCells;
    return {a, b, std::min(a + kBlockCells, posts.columns() - 1), std::min(b + kBlockCells, posts.rows() - 1)};
}

/// Triangles beside a void reach a little beyond their cells.
bool has_ground(const ChunkPosts& posts, std::uint32_t a, std::uint32_t b) {
    return !posts.is_void(a, b) || !posts.is_void(a + 1, b) || !posts.is_void(a, b + 1) || !posts.is_void(a + 1, b + 1);
}

ViewBox box_of(const ChunkPosts& posts, const Block& block) {
    ViewBox box;
    bool any = false;
    for (std::uint32_t b = block.b0; b < block.b1; ++b)
        for (std::uint32_t a = block.a0; a < block.a1; ++a) any = any || has_ground(posts, a, b);
    if (!any) return box;
    for (std::uint32_t b = block.b0; b <= block.b1; ++b)
        for (std::uint32_t a = block.a0; a <= block.a1; ++a) box.include(posts.place(a, b));
    return box;
}

std::uint32_t block_in_group(std::uint32_t group, std::uint32_t member) {
    const std::uint32_t a = group % kGroups * kGroupBlocks + member % kGroupBlocks;
    const std::uint32_t b = group / kGroups * kGroupBlocks + member / kGroupBlocks;
    return b * kBlocks + a;
}

/// The places of a block's posts, row by row.
struct BlockPlaces {
    BlockPlaces(const ChunkPosts& posts, const Block& block) {
        for (std::uint32_t b = block.b0; b <= block.b1; ++b)
            for (std::uint32_t a = block.a0; a <= block.a1; ++a) place[b - block.b0][a - block.a0] = posts.place(a, b);
    }

    glm::dvec3 place[kBlockCells + 1][kBlockCells + 1];
};

/// The greatest bound of the block's triangles, or `least` if this is more.
double px_per_m_of_cells(const ChunkPosts& posts, const Block& block, const GroundScan& scan, double least) {
    const BlockPlaces places(posts, block);
    double px_per_m = least;
    const auto include = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
        if (!scan.is_at_most(px_per_m, p, q, r)) px_per_m = std::max(px_per_m, scan.px_per_m(p, q, r));
    };
    for (std::uint32_t b = block.b0; b < block.b1; ++b)
        for (std::uint32_t a = block.a0; a < block.a1; ++a) {
            if (!has_ground(posts, a, b)) continue;
            const glm::dvec3* const north = places.place[b - block.b0] + (a - block.a0);
            const glm::dvec3* const south = places.place[b - block.b0 + 1] + (a - block.a0);
            include(north[0], south[0], north[1]);
            include(south[1], north[1], south[0]);
        }
    return px_per_m;
}

/// From the roots down, the closest first, as far as it can say more.
class Descent {
public:
    Descent(HeightQuery& heights, const View& view) : heights_(heights), view_(view) {
        const earth::Geodetic place = earth::from_ecef(view.eye);
        down_ = earth::north_east_down(place.latitude_rad, place.longitude_rad)[2];
        view_.ground = {};
    }

    /// Margins must ascend: what a smaller one allows, a larger one does.
    double px_per_m(double margin_m) {
        margin_m_ = margin_m;
        looks_ = 0;
        const Lattice& lattice = heights_.lattice();
        const std::uint32_t top = lattice.levels() - 1;
        for (std::uint32_t j = 0; j < lattice.grid_rows(top); ++j)
            for (std::uint32_t i = 0; i < lattice.grid_columns(top); ++i) {
                const ChunkKey root{top, i, j};
                const ChunkEntry* const entry = heights_.entry_of(root);
                stack_[waiting_++] = {
                    root, entry == nullptr ? std::numeric_limits<double>::infinity() : px_per_m_in_box(*entry, view_, margin_m_)};
                while (waiting_ > 0) look_at(stack_[--waiting_]);
            }
        return most_;
    }

private:
    struct Candidate {
        ChunkKey key;
        double px_per_m;  ///< no more than that in it, by its own box and those that contain it
    };
    struct BlockBound {
        std::uint32_t block;
        double px_per_m;  ///< no more than that in it
    };
    /// Of a chunk in the view: boxes of groups of blocks, and those of blocks where any margin has asked for them.
    struct Blocks {
        ChunkKey key = kNoChunk;
        ViewBox groups[kGroups * kGroups], boxes[kBlocks * kBlocks];
        bool has_boxes[kGroups * kGroups];
    };

    void include(double px_per_m) { most_ = std::max(most_, px_per_m); }

    void look_at(const Candidate& candidate) {
        if (candidate.px_per_m <= most_) return;
        const ChunkEntry* const found = heights_.entry_of(candidate.key);
        if (found == nullptr || looks_ == kMaxLooks) return include(candidate.px_per_m);
        const ChunkEntry entry = *found;
        if ((entry.flags & (kChunkHasSea | kChunkHasLand)) == 0) return;
        if (entry.children == 0) return include(std::min(candidate.px_per_m, px_per_m_of_posts(entry)));
        ++looks_;
        add_children(entry, candidate.px_per_m);
    }

    /// The one that could move pixels most is looked at first.
    void add_children(const ChunkEntry& entry, double px_per_m) {
        const std::uint32_t first = waiting_;
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            if ((entry.children >> quadrant & 1u) == 0) continue;
            const ChunkKey key = key_of(entry).child(quadrant);
            const ChunkEntry* const child = heights_.entry_of(key);
            if (child == nullptr) return include(px_per_m);
            stack_[waiting_++] = {key, std::min(px_per_m, px_per_m_in_box(*child, view_, margin_m_))};
        }
        std::sort(stack_ + first, stack_ + waiting_,
                  [](const Candidate& a, const Candidate& b) { return a.px_per_m < b.px_per_m; });
    }

    double px_per_m_of_posts(const ChunkEntry& entry) {
        const double side_m = std::min(double{entry.half_extent_m[0]}, double{entry.half_extent_m[1]});
        if (!(box_distance_m(entry, view_) < kBeside * side_m)) return std::numeric_limits<double>::infinity();
        Blocks* const blocks = blocks_of(entry);
        const ExactChunk chunk = blocks != nullptr ? chunk_of(entry) : ExactChunk{};
        if (chunk.entry == nullptr) return std::numeric_limits<double>::infinity();
        const ChunkPosts posts(heights_.lattice(), chunk, view_);
        const GroundScan scan(view_, down_, margin_m_, std::max(double{entry.above_m}, double{entry.below_m}));
        double px_per_m = most_;
        const std::uint32_t count = find_greater(*blocks, posts, scan, px_per_m);
        for (std::uint32_t n = 0; n < count && greater_[n].px_per_m > px_per_m; ++n) {
            const double of_cells = px_per_m_of_cells(posts, block_of(posts, greater_[n].block), scan, px_per_m);
            px_per_m = std::min(greater_[n].px_per_m, of_cells);
        }
        return px_per_m;
    }

    /// Into `greater_`: the blocks whose boxes allow more than `least`, the greatest first. Returns how many there are. A box
    /// allows no more than one that contains it.
    std::uint32_t find_greater(Blocks& blocks, const ChunkPosts& posts, const GroundScan& scan, double least) {
        std::uint32_t count = 0;
        for (std::uint32_t group = 0; group < kGroups * kGroups; ++group) {
            if (!(scan.px_per_m(blocks.groups[group]) > least)) continue;
            if (!blocks.has_boxes[group]) add_boxes(blocks, posts, group);
            for (std::uint32_t member = 0; member < kGroupBlocks * kGroupBlocks; ++member) {
                const std::uint32_t n = block_in_group(group, member);
                const double px_per_m = scan.px_per_m(blocks.boxes[n]);
                if (px_per_m > least) greater_[count++] = {n, px_per_m};
            }
        }
        std::sort(greater_, greater_ + count, [](const BlockBound& a, const BlockBound& b) { return a.px_per_m > b.px_per_m; });
        return count;
    }

    static void add_boxes(Blocks& blocks, const ChunkPosts& posts, std::uint32_t group) {
        blocks.has_boxes[group] = true;
        for (std::uint32_t member = 0; member < kGroupBlocks * kGroupBlocks; ++member) {
            const std::uint32_t n = block_in_group(group, member);
            blocks.boxes[n] = box_of(posts, block_of(posts, n));
        }
    }

    ExactChunk chunk_of(const ChunkEntry& entry) {
        const PostRange range = heights_.lattice().posts_of(key_of(entry));
        return heights_.exact_chunk(range.i0, range.j0);
    }

    /// Made once for all margins; null when there are enough, or its vertices cannot be had.
    Blocks* blocks_of(const ChunkEntry& entry) {
        std::uint32_t place = 0;
        while (place < known_ && blocks_[place].key != key_of(entry)) ++place;
        if (place < known_) return &blocks_[place];
        if (known_ == kMaxChunks) return nullptr;
        const ExactChunk chunk = chunk_of(entry);
        if (chunk.entry == nullptr) return nullptr;
        Blocks& blocks = blocks_[known_++];
        blocks.key = key_of(entry);
        for (std::uint32_t group = 0; group < kGroups * kGroups; ++group) {
            blocks.groups[group] = seen_block(*chunk.entry, chunk.extents->blocks[group], view_);
            blocks.has_boxes[group] = false;
        }
        return &blocks;
    }

    HeightQuery& heights_;
    View view_;
    glm::dvec3 down_;
    double margin_m_ = 0, most_ = 0;
    Candidate stack_[3 * kMaxLevels + 1];  // of each look but the last at most three others wait
    std::uint32_t waiting_ = 0, looks_ = 0, known_ = 0;
    Blocks blocks_[kMaxChunks];
    BlockBound greater_[kBlocks * kBlocks];
};

}  // namespace

NearGround near_ground(HeightQuery& heights, const View& view) {
    NearGround ground;
    if (!is_finite(view)) return ground;
    Descent descent(heights, view);
    for (double margin_m = kFirstMargin_m; ground.count < NearGround::kMaxSteps; margin_m *= kMarginRatio) {
        const double px_per_m = descent.px_per_m(margin_m);
        if (!std::isfinite(px_per_m)) break;
        ground.steps[ground.count++] = {margin_m, px_per_m};
    }
    return ground;
}

}  // namespace tedavis::terrain
