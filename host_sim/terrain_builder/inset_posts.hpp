/// The posts of a region of insets: stored on disk within the region, interpolated from the coarse posts outside.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/ground.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"

namespace tedavis::host_sim {

/// Fills a window of posts, 2^shift to a coarse one, linearly on the coarse posts' triangles; post (0, 0) is the same in both. A
/// fine post is void if a coarse post used is. Posts beyond the coarse lattice are outside.
void interpolate_posts(const PostsFile& coarse, std::uint32_t shift, LatticeWindow& fine);

class InsetPosts final : public PostWindows {
public:
    /// `region` is in fine posts, with its corners at coarse ones. Opens or makes `<path>.heights` and `<path>.classes`.
    InsetPosts(const PostsFile& coarse, std::uint32_t shift, const terrain::PostRange& region, const std::string& path);

    [[nodiscard]] const terrain::PostRange& region() const { return region_; }
    void read(LatticeWindow& window) const override;
    /// All posts of the window lie in the region.
    void write(const LatticeWindow& window);
    void sync() { posts_.sync(); }

private:
    const PostsFile& coarse_;
    std::uint32_t shift_;
    terrain::PostRange region_;
    PostsFile posts_;
};

/// Blocks of a region: its chunks of the base level, row by row.
class RegionBlocks {
public:
    RegionBlocks(const terrain::PostRange& region, std::uint32_t base_level);

    [[nodiscard]] std::uint32_t count() const { return across_ * down_; }
    [[nodiscard]] terrain::ChunkKey chunk(std::uint32_t block) const;

private:
    std::uint32_t level_, first_i_, first_j_, across_, down_;
};

}  // namespace tedavis::host_sim
