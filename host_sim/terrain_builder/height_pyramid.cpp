#include "host_sim/terrain_builder/height_pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "host_sim/terrain_builder/ordered_tasks.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::PostClass;

constexpr std::uint32_t kBlock = 512;  // posts of a task along a side
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

std::uint32_t halved(std::uint32_t posts) { return std::max(2u, posts / 2 + 1); }

struct Block {
    std::uint32_t i, j, columns, rows;
};

struct Blocks {
    std::uint32_t columns, rows;

    [[nodiscard]] std::uint32_t across() const { return (columns + kBlock - 1) / kBlock; }
    [[nodiscard]] std::uint32_t count() const { return across() * ((rows + kBlock - 1) / kBlock); }
    [[nodiscard]] Block at(std::uint32_t index) const {
        const std::uint32_t i = index % across() * kBlock, j = index / across() * kBlock;
        return {i, j, std::min(kBlock, columns - i), std::min(kBlock, rows - j)};
    }
};

/// Void posts of level 0 hold 0, unknown ones of the levels above NaN.
bool is_known(const LatticeWindow& window, std::size_t n, std::uint32_t level) {
    return level == 0 ? window.post_class[n] <= PostClass::sea
                      : window.post_class[n] != PostClass::outside && !std::isnan(window.height_m[n]);
}

struct Mean {
    float height_m;
    PostClass post_class;
};

/// Of the posts round `centre` of a window of level `level`.
Mean mean_round(const LatticeWindow& window, std::size_t centre, std::uint32_t level) {
    static constexpr int kWeight[3] = {1, 2, 1};
    float sum = 0;
    int known = 0;
    std::array<int, 4> weight_of{};
    for (int dj = 0; dj < 3; ++dj)
        for (int di = 0; di < 3; ++di) {
            const std::size_t n =
                centre + static_cast<std::size_t>(dj) * window.columns + static_cast<std::size_t>(di) - window.columns - 1;
            const int weight = kWeight[di] * kWeight[dj];
            weight_of[static_cast<std::size_t>(window.post_class[n])] += weight;
            if (!is_known(window, n, level)) continue;
            sum += static_cast<float>(weight) * window.height_m[n];
            known += weight;
        }
    const int land = weight_of[0], sea = weight_of[1], voids = weight_of[2];
    const PostClass post_class = voids > land + sea ? PostClass::void_ : sea > land ? PostClass::sea : PostClass::land;
    return {known == 0 ? kUnknown : sum / static_cast<float>(known), post_class};
}

void halve_block(const PostsFile& fine, std::uint32_t fine_level, PostsFile& coarse, const Block& block) {
    LatticeWindow window;
    window.i0 = 2 * std::int64_t{block.i} - 1;
    window.j0 = 2 * std::int64_t{block.j} - 1;
    window.columns = 2 * block.columns + 1;
    window.rows = 2 * block.rows + 1;
    fine.read(window);
    std::vector<float> heights;
    std::vector<PostClass> classes;
    for (std::uint32_t j = 0; j < block.rows; ++j)
        for (std::uint32_t i = 0; i < block.columns; ++i) {
            const std::size_t centre = std::size_t{2 * j + 1} * window.columns + 2 * i + 1;
            const Mean mean = mean_round(window, centre, fine_level);
            heights.push_back(mean.height_m);
            classes.push_back(mean.post_class);
        }
    coarse.write(block.i, block.j, block.columns, block.rows, heights, classes);
}

/// The closing column is the first one, also where halving has moved it.
void close_level(PostsFile& level) {
    for (std::uint32_t j = 0; j < level.rows(); ++j) {
        LatticeWindow first;
        first.j0 = j;
        first.columns = first.rows = 1;
        level.read(first);
        level.write(level.columns() - 1, j, 1, 1, first.height_m, first.post_class);
    }
}

/// Heights of a coarser level between its posts.
class CoarseHeights {
public:
    CoarseHeights(const PostsFile* coarse, const Block& fine) {
        if (coarse == nullptr) return;
        window_.i0 = fine.i / 2;
        window_.j0 = fine.j / 2;
        window_.columns = std::min(fine.columns / 2 + 2, coarse->columns() - fine.i / 2);
        window_.rows = std::min(fine.rows / 2 + 2, coarse->rows() - fine.j / 2);
        coarse->read(window_);
    }
    /// At a post of the level below.
    [[nodiscard]] float at(std::uint32_t i, std::uint32_t j) const {
        if (window_.height_m.empty()) return 0;
        const std::int64_t last_i = window_.i0 + window_.columns - 1, last_j = window_.j0 + window_.rows - 1;
        const std::int64_t west = std::min<std::int64_t>(i / 2, last_i), east = std::min<std::int64_t>((i + 1) / 2, last_i);
        const std::int64_t north = std::min<std::int64_t>(j / 2, last_j), south = std::min<std::int64_t>((j + 1) / 2, last_j);
        const auto height = [this](std::int64_t a, std::int64_t b) { return window_.height_m[window_.at(a, b)]; };
        return 0.25f * ((height(west, north) + height(east, north)) + (height(west, south) + height(east, south)));
    }

private:
    LatticeWindow window_;
};

void fill_block(const PostsFile& fine, bool is_posts, const PostsFile* coarse, PostsFile& target, const Block& block) {
    LatticeWindow window;
    window.i0 = block.i;
    window.j0 = block.j;
    window.columns = block.columns;
    window.rows = block.rows;
    fine.read(window);
    const auto unknown = [&](std::size_t n) { return !is_known(window, n, is_posts ? 0 : 1); };
    std::size_t n = 0;
    while (n < window.height_m.size() && !unknown(n)) ++n;
    if (is_posts && n == window.height_m.size()) return;
    const CoarseHeights heights(coarse, block);
    for (; n < window.height_m.size(); ++n)
        if (unknown(n))
            window.height_m[n] = heights.at(block.i + static_cast<std::uint32_t>(n % block.columns),
                                            block.j + static_cast<std::uint32_t>(n / block.columns));
    target.write(block.i, block.j, block.columns, block.rows, window.height_m, window.post_class);
}

}  // namespace

HeightPyramid::HeightPyramid(std::string folder, PostsFile& posts, bool closed)
    : folder_(std::move(folder)), posts_(posts), closed_(closed) {
    std::uint32_t columns = posts.columns(), rows = posts.rows();
    while (columns > 2 || rows > 2) {
        columns = halved(columns);
        rows = halved(rows);
        levels_.emplace_back(folder_ + "/level." + std::to_string(levels_.size() + 1), columns, rows, closed);
    }
}

void HeightPyramid::build(base::Workers& workers, const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
    std::uint64_t total = 0, done = 0;
    for (const PostsFile& level : levels_) total += Blocks{level.columns(), level.rows()}.count();
    for (std::uint32_t m = 1; m < level_count(); ++m) build_level(m, workers, [&] { progress(++done, total); });
}

void HeightPyramid::build_level(std::uint32_t m, base::Workers& workers, const std::function<void()>& block_done) {
    const PostsFile& fine = level(m - 1);
    PostsFile& coarse = level(m);
    const Blocks blocks{coarse.columns(), coarse.rows()};
    run_in_order(
        workers, 0, blocks.count(),
        [&](std::uint32_t index) {
            halve_block(fine, m - 1, coarse, blocks.at(index));
            return true;
        },
        [&](std::uint32_t, bool) { block_done(); });
    if (closed_) close_level(coarse);
}

void HeightPyramid::fill_voids(base::Workers& workers, const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
    std::uint64_t total = Blocks{posts_.columns(), posts_.rows()}.count(), done = 0;
    for (const PostsFile& level : levels_) total += Blocks{level.columns(), level.rows()}.count();
    const auto block_done = [&] { progress(++done, total); };
    std::deque<PostsFile> filled;  // from the coarsest on
    const PostsFile* above = nullptr;
    for (std::size_t m = levels_.size(); m-- > 0;) {
        PostsFile& level = levels_[m];
        filled.emplace_back(folder_ + "/filled." + std::to_string(m + 1), level.columns(), level.rows(), closed_);
        fill_level(level, above, filled.back(), workers, block_done);
        above = &filled.back();
    }
    fill_level(posts_, above, posts_, workers, block_done);
    filled.clear();
    for (std::size_t m = levels_.size(); m-- > 0;)
        for (const char* part : {".heights", ".classes"})
            std::remove((folder_ + "/filled." + std::to_string(m + 1) + part).c_str());
}

void HeightPyramid::fill_level(PostsFile& fine, const PostsFile* coarse, PostsFile& target, base::Workers& workers,
                               const std::function<void()>& block_done) {
    const Blocks blocks{fine.columns(), fine.rows()};
    run_in_order(
        workers, 0, blocks.count(),
        [&](std::uint32_t index) {
            fill_block(fine, &fine == &posts_, coarse, target, blocks.at(index));
            return true;
        },
        [&](std::uint32_t, bool) { block_done(); });
}

}  // namespace tedavis::host_sim
