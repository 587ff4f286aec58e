#include "host_sim/terrain_builder/import_posts.hpp"

#include <algorithm>
#include <utility>

namespace tedavis::host_sim {
namespace {

using terrain::PostClass;

constexpr std::uint32_t kBlockColumns = 4096;
// A band of blocks fits into the block cache of the reader: strips and tiles of a file are unpacked once.
constexpr std::uint32_t kBandPosts = 8u << 20, kFewestBandRows = 16, kMaxBandRows = 256;

struct PoleHeight {
    double sum = 0;
    std::uint64_t valid = 0;
    bool all_sea = true;

    void include(const LatticeWindow& row, std::uint32_t posts) {
        for (std::uint32_t n = 0; n < posts; ++n) {
            if (row.post_class[n] > PostClass::sea) continue;
            sum += row.height_m[n];
            ++valid;
            all_sea = all_sea && row.post_class[n] == PostClass::sea;
        }
    }
    [[nodiscard]] float height_m() const { return valid == 0 ? 0.0f : static_cast<float>(sum / static_cast<double>(valid)); }
    [[nodiscard]] PostClass post_class() const {
        return valid == 0 ? PostClass::void_ : all_sea ? PostClass::sea : PostClass::land;
    }
};

void make_pole_row(PostsFile& posts, std::uint32_t pole, std::uint32_t ring, bool closed) {
    PoleHeight height;
    const std::uint32_t own_columns = posts.columns() - (closed ? 1 : 0);
    for (std::uint32_t i = 0; i < posts.columns(); i += kBlockColumns) {
        LatticeWindow row;
        row.i0 = i;
        row.j0 = ring;
        row.columns = std::min(kBlockColumns, posts.columns() - i);
        row.rows = 1;
        posts.read(row);
        height.include(row, std::min(row.columns, own_columns - std::min(i, own_columns)));
    }
    const std::vector<float> heights(kBlockColumns, height.height_m());
    const std::vector<PostClass> classes(kBlockColumns, height.post_class());
    for (std::uint32_t i = 0; i < posts.columns(); i += kBlockColumns)
        posts.write(i, pole, std::min(kBlockColumns, posts.columns() - i), 1, heights, classes);
}

}  // namespace

void PostStatistics::include_heights(const PostStatistics& other) {
    min_height_m = std::min(min_height_m, other.min_height_m);
    max_height_m = std::max(max_height_m, other.max_height_m);
}

void PostStatistics::include(const PostStatistics& other) {
    include_heights(other);
    valid_posts += other.valid_posts;
    void_posts += other.void_posts;
}

void PostStatistics::include(base::Span<const float> heights_m, base::Span<const PostClass> classes) {
    for (std::size_t n = 0; n < heights_m.size(); ++n) {
        if (classes[n] > PostClass::sea) {
            ++void_posts;
            continue;
        }
        ++valid_posts;
        min_height_m = std::min(min_height_m, heights_m[n]);
        max_height_m = std::max(max_height_m, heights_m[n]);
    }
}

ImportBlocks::ImportBlocks(const BuildPlan& plan)
    : columns_(plan.source_columns),
      rows_(plan.source.rows),
      block_rows_(std::clamp(kBandPosts / columns_, kFewestBandRows, kMaxBandRows)),
      across_((columns_ + kBlockColumns - 1) / kBlockColumns),
      down_((rows_ + block_rows_ - 1) / block_rows_) {}

ImportBlocks::Block ImportBlocks::at(std::uint32_t index) const {
    const std::uint32_t i = index % across_ * kBlockColumns, j = index / across_ * block_rows_;
    return {i, j, std::min(kBlockColumns, columns_ - i), std::min(block_rows_, rows_ - j)};
}

PostStatistics PostImport::import(std::uint32_t index) {
    const ImportBlocks::Block block = blocks_.at(index);
    const std::size_t count = std::size_t{block.columns} * block.rows;
    std::vector<float> heights(count);
    std::vector<PostClass> classes(count);
    std::unique_ptr<PostReader> reader = readers_.take(open_);
    reader->read(block.i, block.j, block.columns, block.rows, heights, classes);
    for (std::size_t n = 0; n < count; ++n)
        if (classes[n] == PostClass::void_) heights[n] = 0;
    posts_.write(block.i, block.j + plan_.first_source_row, block.columns, block.rows, heights, classes);
    if (plan_.lattice.is_closed() && block.i == 0) close_columns(block, heights, classes);
    PostStatistics statistics;
    statistics.include(heights, classes);
    readers_.give_back(std::move(reader));
    return statistics;
}

/// The last column of a lattice round the Earth is the first one again.
void PostImport::close_columns(const ImportBlocks::Block& block, const std::vector<float>& heights_m,
                               const std::vector<PostClass>& classes) {
    for (std::uint32_t j = 0; j < block.rows; ++j) {
        const std::size_t first = std::size_t{j} * block.columns;
        posts_.write(posts_.columns() - 1, block.j + plan_.first_source_row + j, 1, 1, {&heights_m[first], 1},
                     {&classes[first], 1});
    }
}

void make_pole_rows(const BuildPlan& plan, PostsFile& posts) {
    // A row that the source itself has at the pole is its own ring.
    const bool closed = plan.lattice.is_closed();
    const std::uint32_t last = posts.rows() - 1;
    const bool south_added = plan.first_source_row + plan.source.rows < posts.rows();
    if (plan.has_north_pole()) make_pole_row(posts, 0, plan.first_source_row, closed);
    if (plan.has_south_pole()) make_pole_row(posts, last, south_added ? last - 1 : last, closed);
}

}  // namespace tedavis::host_sim
