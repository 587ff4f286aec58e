/// The fine posts of a region: the coarse surface with the insets blended in.
///
/// An inset's weight rises linearly from 0 at its rim, also at that of its voids, to 1 at kBlendPosts posts from it, along rows,
/// columns or diagonals. So there is no step where it begins, whatever the heights differ by.
#pragma once

#include <memory>
#include <vector>

#include "host_sim/terrain_builder/idle_pool.hpp"
#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/inset_posts.hpp"
#include "host_sim/terrain_builder/post_reader.hpp"

namespace tedavis::host_sim {

inline constexpr std::uint32_t kBlendPosts = 32;

/// Posts of an inset at posts of the database's lattice, interpolated bilinearly; void where a post it stands on is.
class InsetSampler {
public:
    InsetSampler(const BuildPlan& fine, const PostReaderFactory& open) : fine_(fine), open_(open) {}

    /// Heights and classes of the window; posts beyond the inset are void. Any thread.
    void read(LatticeWindow& window);
    /// The lattice's posts within the inset; empty (i1 < i0) where it has none.
    [[nodiscard]] terrain::PostRange footprint();

private:
    struct Axis {
        double first, step;  // of a lattice post in posts of the inset
    };
    [[nodiscard]] Axis east_axis(const PostGrid& grid) const;
    [[nodiscard]] Axis south_axis(const PostGrid& grid) const;

    const BuildPlan& fine_;
    PostReaderFactory open_;
    IdlePool<PostReader> readers_;
};

class InsetImport {
public:
    /// Later insets lie over earlier ones.
    InsetImport(std::vector<std::unique_ptr<InsetSampler>>& insets, InsetPosts& posts, const PostsFile& coarse,
                std::uint32_t shift)
        : insets_(insets), posts_(posts), coarse_(coarse), shift_(shift) {}

    /// Any thread, different blocks at once; the coarse posts must still be the raster's own. Returns what the block holds.
    [[nodiscard]] PostStatistics import(const terrain::PostRange& block);
    /// Coarse posts in the block become what the fine ones are. All blocks must have been imported.
    void write_back(const terrain::PostRange& block, PostsFile& coarse) const;
    /// Void posts get a height from the coarse ones, whose voids are filled.
    void fill_voids(const terrain::PostRange& block);

private:
    std::vector<std::unique_ptr<InsetSampler>>& insets_;
    InsetPosts& posts_;
    const PostsFile& coarse_;
    std::uint32_t shift_;
};

}  // namespace tedavis::host_sim
