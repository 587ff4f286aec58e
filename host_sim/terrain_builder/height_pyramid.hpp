/// The heights at halved resolutions, and heights interpolated from them for posts that the sources lack.
///
/// Level 0 is the posts file. Post n of level m+1 is at the place of post 2n of level m; its height is the mean of the known
/// posts around it with weights 1 2 1 in both directions (Burt, Adelson, "The Laplacian Pyramid as a Compact Image Code", IEEE
/// Trans. Communications 31(4), 1983, with a = 1/2). Its class is the one with the greatest sum of weights; void only where void
/// has most of the weight. Unknown heights are NaN. The result does not depend on the order or the number of threads.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "host_sim/terrain_builder/height_levels.hpp"
#include "host_sim/terrain_builder/posts_file.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

/// Number of blocks of a rectangle of posts of a level, and one block made from the next finer level, with heights, classes and
/// place.
[[nodiscard]] std::uint32_t halving_block_count(const terrain::PostRange& posts);
[[nodiscard]] LatticeWindow halved_block(const PostWindows& fine, std::uint32_t fine_level, const terrain::PostRange& posts,
                                         std::uint32_t block);

class HeightPyramid final : public HeightLevels {
public:
    /// Opens or makes the files of levels 1 and above, `<folder>/level.<m>` and `filled.<m>`, up to the one of two by two posts.
    HeightPyramid(const std::string& folder, PostsFile& posts, bool closed);

    /// Number of levels, the posts file included.
    [[nodiscard]] std::uint32_t level_count() const override { return static_cast<std::uint32_t>(levels_.size()) + 1; }
    [[nodiscard]] PostsFile& level(std::uint32_t m) { return m == 0 ? posts_ : levels_[m - 1]; }
    [[nodiscard]] const PostsFile& level(std::uint32_t m) const { return m == 0 ? posts_ : levels_[m - 1]; }
    [[nodiscard]] std::uint32_t columns(std::uint32_t m) const override { return level(m).columns(); }
    [[nodiscard]] std::uint32_t rows(std::uint32_t m) const override { return level(m).rows(); }
    void read(std::uint32_t m, LatticeWindow& window) const override { level(m).read(window); }

    /// Number of blocks of a level, one per task. Blocks of a level are independent of each other.
    [[nodiscard]] std::uint32_t block_count(std::uint32_t m) const;
    /// Makes a block of a level m, 1 or above, from level m - 1, which must be complete. Any thread.
    void build_block(std::uint32_t m, std::uint32_t block);
    /// Sets a height for every void post of a block, interpolated linearly from the next coarser level. To be called from the
    /// coarsest level down to level 0, each after the coarser one is complete. Filled heights of coarser levels are stored beside
    /// their known ones; those of level 0 are written to the posts file. Source: Gortler et al., "The Lumigraph", SIGGRAPH 1996,
    /// 3.4.1 (pull-push).
    void fill_block(std::uint32_t m, std::uint32_t block);
    void sync();

private:
    PostsFile& posts_;
    bool closed_;
    std::deque<PostsFile> levels_, filled_;  // from level 1 on
};

}  // namespace tedavis::host_sim
