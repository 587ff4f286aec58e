#include "host_sim/terrain_builder/inset_pyramid.hpp"

#include <algorithm>

namespace tedavis::host_sim {

using namespace terrain;

RegionPyramid::RegionPyramid(const InsetPosts& posts, const PostsFile& coarse, std::uint32_t base_level, const std::string& path)
    : posts_(posts) {
    const PostRange& region = posts.region();
    for (std::uint32_t m = 1; m < base_level; ++m)
        levels_.emplace_back(coarse, base_level - m, PostRange{region.i0 >> m, region.j0 >> m, region.i1 >> m, region.j1 >> m},
                             path + ".level." + std::to_string(m));
}

const PostWindows& RegionPyramid::level(std::uint32_t m) const {
    return m == 0 ? static_cast<const PostWindows&>(posts_) : levels_[m - 1];
}

std::uint32_t RegionPyramid::block_count(std::uint32_t m) const { return halving_block_count(levels_[m - 1].region()); }

void RegionPyramid::build_block(std::uint32_t m, std::uint32_t block) {
    InsetPosts& target = levels_[m - 1];
    LatticeWindow window = halved_block(level(m - 1), m - 1, target.region(), block);
    target.write(window);
}

void RegionPyramid::sync() {
    for (InsetPosts& level : levels_) level.sync();
}

void RegionPyramid::read(std::uint32_t m, LatticeWindow& window) const { level(m).read(window); }

bool RegionPyramid::holds_middle(std::uint32_t m, const LatticeWindow& window) const {
    const PostRange& region = posts_.region();
    const std::int64_t i = (window.i0 + window.columns / 2) * (std::int64_t{1} << m),
                       j = (window.j0 + window.rows / 2) * (std::int64_t{1} << m);
    return i >= region.i0 && i <= region.i1 && j >= region.j0 && j <= region.j1;
}

std::uint32_t InsetPyramid::columns(std::uint32_t level) const {
    return level >= base_level_ ? coarse_.level(level - base_level_).columns() : ((fine_.columns() - 1) >> level) + 1;
}

std::uint32_t InsetPyramid::rows(std::uint32_t level) const {
    return level >= base_level_ ? coarse_.level(level - base_level_).rows() : ((fine_.rows() - 1) >> level) + 1;
}

void InsetPyramid::read(std::uint32_t level, LatticeWindow& window) const {
    if (level >= base_level_) return coarse_.level(level - base_level_).read(window);
    for (const RegionPyramid* region : regions_)
        if (region->holds_middle(level, window)) return region->read(level, window);
    interpolate_posts(coarse_.level(0), base_level_ - level, window);
}

}  // namespace tedavis::host_sim
