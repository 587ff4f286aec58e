#include "host_sim/terrain_builder/inset_slopes.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

using namespace terrain;

std::uint32_t chunks_across(std::uint32_t first, std::uint32_t last) { return (last - first + kChunkCells - 1) / kChunkCells; }

}  // namespace

InsetSlopes::InsetSlopes(const BuildPlan& plan, const SlopeMap& coarse, std::uint32_t shift, const InsetPosts& posts,
                         const std::string& path)
    : plan_(plan),
      coarse_(coarse),
      shift_(shift),
      posts_(posts),
      columns_(chunks_across(posts.region().i0, posts.region().i1)),
      rows_(chunks_across(posts.region().j0, posts.region().j1)),
      slope_(std::size_t{columns_} * rows_),
      file_(path) {
    file_.resize(slope_.size() * sizeof(float));
    file_.read(0, slope_.data(), slope_.size() * sizeof(float));
}

void InsetSlopes::measure(const ChunkKey& block) {
    const PostRange range = plan_.lattice.posts_of(block), &region = posts_.region();
    LatticeWindow window;
    window.i0 = range.i0;
    window.j0 = range.j0;
    window.columns = range.i1 - range.i0 + 1;
    window.rows = range.j1 - range.j0 + 1;
    posts_.read(window);
    for (std::uint32_t j = range.j0; j < range.j1; j += kChunkCells)
        for (std::uint32_t i = range.i0; i < range.i1; i += kChunkCells) {
            const std::size_t n = std::size_t{(j - region.j0) / kChunkCells} * columns_ + (i - region.i0) / kChunkCells;
            slope_[n] = steepest_slope(plan_, window, plan_.lattice.posts_of({0, i / kChunkCells, j / kChunkCells}));
            file_.write(n * sizeof(float), &slope_[n], sizeof(float));
        }
}

double InsetSlopes::steepest(const PostRange& posts, std::uint32_t margin_posts) const {
    const std::uint32_t side = 1u << shift_;
    const PostRange coarse{posts.i0 / side, posts.j0 / side, std::max((posts.i1 + side - 1) / side, posts.i0 / side + 1),
                           std::max((posts.j1 + side - 1) / side, posts.j0 / side + 1)};
    double steepest = coarse_.steepest(coarse, margin_posts / side + 1);
    const PostRange& region = posts_.region();
    const auto low = [&](std::uint32_t post, std::uint32_t first) {
        const std::uint32_t from = post > margin_posts ? post - margin_posts : 0;
        return from > first ? (from - first) / kChunkCells : 0;
    };
    const auto high = [&](std::uint32_t post, std::uint32_t first, std::uint32_t count) {
        const std::uint64_t to = std::uint64_t{post} + margin_posts;
        return to <= first
                   ? 0u
                   : static_cast<std::uint32_t>(std::min<std::uint64_t>((to - first + kChunkCells - 1) / kChunkCells, count));
    };
    for (std::uint32_t j = low(posts.j0, region.j0); j < high(posts.j1, region.j0, rows_); ++j)
        for (std::uint32_t i = low(posts.i0, region.i0); i < high(posts.i1, region.i0, columns_); ++i)
            steepest = std::max(steepest, double{slope_[std::size_t{j} * columns_ + i]});
    return steepest;
}

}  // namespace tedavis::host_sim
