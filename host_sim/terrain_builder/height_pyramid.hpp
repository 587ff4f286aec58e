/// The heights at halved resolutions, and from them heights to draw where the sources have none.
///
/// Level 0 is the posts file. Post n of level m+1 stands where post 2n of level m stands; its height is the mean of the known
/// posts round it with weights 1 2 1 both ways (Burt, Adelson, "The Laplacian Pyramid as a Compact Image Code", IEEE Trans.
/// Communications 31(4), 1983, with a = 1/2). Its class is the heaviest one; void only where void has most of the weight.
/// Unknown heights are NaN. Nothing depends on the order or the number of threads.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include "host_sim/terrain_builder/posts_file.hpp"
#include "render_core/base/ports/workers.hpp"

namespace tedavis::host_sim {

class HeightPyramid {
public:
    /// Opens or makes the files of levels 1 and above, `<folder>/level.<m>`, up to the one of two by two posts.
    HeightPyramid(std::string folder, PostsFile& posts, bool closed);

    /// Posts file and the levels above it.
    [[nodiscard]] std::uint32_t level_count() const { return static_cast<std::uint32_t>(levels_.size()) + 1; }
    [[nodiscard]] PostsFile& level(std::uint32_t m) { return m == 0 ? posts_ : levels_[m - 1]; }

    /// Levels 1 and above, each from the one below. `progress` may throw to stop.
    void build(base::Workers& workers, const std::function<void(std::uint64_t, std::uint64_t)>& progress);
    /// Gives every void post of the posts file a height: known heights spread from the coarse levels down, interpolated
    /// linearly. Source: Gortler et al., "The Lumigraph", SIGGRAPH 1996, 3.4.1 (pull-push).
    void fill_voids(base::Workers& workers, const std::function<void(std::uint64_t, std::uint64_t)>& progress);

private:
    void build_level(std::uint32_t m, base::Workers& workers, const std::function<void()>& block_done);
    void fill_level(PostsFile& fine, const PostsFile* coarse, PostsFile& target, base::Workers& workers,
                    const std::function<void()>& block_done);

    std::string folder_;
    PostsFile& posts_;
    bool closed_;
    std::deque<PostsFile> levels_;
};

}  // namespace tedavis::host_sim
