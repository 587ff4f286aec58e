#include "host_sim/terrain_builder/height_pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

LatticeWindow read_window(const PostWindows& level, std::int64_t i0, std::int64_t j0, std::uint32_t columns, std::uint32_t rows) {
    LatticeWindow window;
    window.i0 = i0;
    window.j0 = j0;
    window.columns = columns;
    window.rows = rows;
    level.read(window);
    return window;
}

LatticeWindow halve_block(const PostWindows& fine, std::uint32_t fine_level, const Block& block) {
    const LatticeWindow window = read_window(fine, 2 * std::int64_t{block.i} - 1, 2 * std::int64_t{block.j} - 1,
                                             2 * block.columns + 1, 2 * block.rows + 1);
    LatticeWindow coarse;
    coarse.i0 = block.i;
    coarse.j0 = block.j;
    coarse.columns = block.columns;
    coarse.rows = block.rows;
    for (std::uint32_t j = 0; j < block.rows; ++j)
        for (std::uint32_t i = 0; i < block.columns; ++i) {
            const std::size_t centre = std::size_t{2 * j + 1} * window.columns + 2 * i + 1;
            const Mean mean = mean_round(window, centre, fine_level);
            coarse.height_m.push_back(mean.height_m);
            coarse.post_class.push_back(mean.post_class);
        }
    return coarse;
}

/// The closing column is the first one, also where halving has moved it.
void close_block(const PostsFile& fine, std::uint32_t fine_level, PostsFile& coarse, const Block& block) {
    const LatticeWindow window = read_window(fine, -1, 2 * std::int64_t{block.j} - 1, 3, 2 * block.rows + 1);
    for (std::uint32_t j = 0; j < block.rows; ++j) {
        const Mean mean = mean_round(window, std::size_t{2 * j + 1} * window.columns + 1, fine_level);
        coarse.write(coarse.columns() - 1, block.j + j, 1, 1, {&mean.height_m, 1}, {&mean.post_class, 1});
    }
}

/// Heights of a coarser level between its posts.
class CoarseHeights {
public:
    CoarseHeights(const PostsFile* coarse, const Block& fine) {
        if (coarse == nullptr) return;
        window_ = read_window(*coarse, fine.i / 2, fine.j / 2, std::min(fine.columns / 2 + 2, coarse->columns() - fine.i / 2),
                              std::min(fine.rows / 2 + 2, coarse->rows() - fine.j / 2));
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

void fill_unknown(const PostsFile& fine, bool is_posts, const PostsFile* coarse, PostsFile& target, const Block& block) {
    LatticeWindow window = read_window(fine, block.i, block.j, block.columns, block.rows);
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

std::uint32_t halving_block_count(const terrain::PostRange& posts) {
    return Blocks{posts.i1 - posts.i0 + 1, posts.j1 - posts.j0 + 1}.count();
}

LatticeWindow halved_block(const PostWindows& fine, std::uint32_t fine_level, const terrain::PostRange& posts,
                           std::uint32_t block) {
    Block at = Blocks{posts.i1 - posts.i0 + 1, posts.j1 - posts.j0 + 1}.at(block);
    at.i += posts.i0;
    at.j += posts.j0;
    return halve_block(fine, fine_level, at);
}

HeightPyramid::HeightPyramid(const std::string& folder, PostsFile& posts, bool closed) : posts_(posts), closed_(closed) {
    std::uint32_t columns = posts.columns(), rows = posts.rows();
    while (columns > 2 || rows > 2) {
        columns = halved(columns);
        rows = halved(rows);
        const std::string m = std::to_string(levels_.size() + 1);
        levels_.emplace_back(folder + "/level." + m, columns, rows, closed);
        filled_.emplace_back(folder + "/filled." + m, columns, rows, closed);
    }
}

std::uint32_t HeightPyramid::block_count(std::uint32_t m) const { return Blocks{level(m).columns(), level(m).rows()}.count(); }

void HeightPyramid::build_block(std::uint32_t m, std::uint32_t block) {
    const PostsFile& fine = level(m - 1);
    PostsFile& coarse = level(m);
    const Block at = Blocks{coarse.columns(), coarse.rows()}.at(block);
    const LatticeWindow made = halve_block(fine, m - 1, at);
    coarse.write(at.i, at.j, at.columns, at.rows, {made.height_m.data(), made.height_m.size()},
                 {made.post_class.data(), made.post_class.size()});
    if (closed_ && at.i + at.columns == coarse.columns()) close_block(fine, m - 1, coarse, at);
}

void HeightPyramid::fill_block(std::uint32_t m, std::uint32_t block) {
    const PostsFile* above = m + 1 < level_count() ? &filled_[m] : nullptr;
    PostsFile& target = m == 0 ? posts_ : filled_[m - 1];
    fill_unknown(level(m), m == 0, above, target, Blocks{target.columns(), target.rows()}.at(block));
}

void HeightPyramid::sync() {
    for (PostsFile& file : levels_) file.sync();
    for (PostsFile& file : filled_) file.sync();
}

}  // namespace tedavis::host_sim
