/// The fine posts of a region: the coarse surface with the insets blended in.
///
/// An inset's weight rises linearly from 0 at its border, and at that of its voids, to 1 at kBlendPosts posts from it, along
/// rows, columns or diagonals. So there is no step at its border, however much the heights differ.
#pragma once

#include <memory>
#include <vector>

#include "host_sim/terrain_builder/idle_pool.hpp"
#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/inset_posts.hpp"
#include "host_sim/terrain_builder/post_reader.hpp"

namespace tedavis::host_sim {

inline constexpr std::uint32_t kBlendPosts = 32;

/// Interpolates an inset bilinearly at posts of the database's lattice; the result is void where one of the posts used is.
class InsetSampler {
public:
    InsetSampler(const BuildPlan& fine, const PostReaderFactory& open) : fine_(fine), open_(open) {}

    /// Fills in heights and classes of the window; posts outside the inset are void. Any thread.
    void read(LatticeWindow& window);
    /// Returns the lattice's posts within the inset; empty (i1 < i0) where there are none.
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
    /// Later insets override earlier ones. All references must outlive this object.
    InsetImport(std::vector<std::unique_ptr<InsetSampler>>& insets, InsetPosts& posts, const PostsFile& coarse,
                std::uint32_t shift)
        : insets_(insets), posts_(posts), coarse_(coarse), shift_(shift) {}

    /// Imports a block and returns its statistics. The coarse posts must still be those of the raster. Different blocks may be
    /// imported at once, on any thread.
    [[nodiscard]] PostStatistics import(const terrain::PostRange& block);
    /// Sets the coarse posts in the block to the fine ones at their places. All blocks must have been imported.
    void write_back(const terrain::PostRange& block, PostsFile& coarse) const;
    /// Sets heights of void posts from the coarse ones, whose voids must be filled.
    void fill_voids(const terrain::PostRange& block);

private:
    std::vector<std::unique_ptr<InsetSampler>>& insets_;
    InsetPosts& posts_;
    const PostsFile& coarse_;
    std::uint32_t shift_;
};

}  // namespace tedavis::host_sim
