#include "host_sim/terrain_builder/inset_posts.hpp"

#include <algorithm>
#include <array>

namespace tedavis::host_sim {
namespace {

using namespace terrain;

struct CoarseCell {
    std::array<float, 4> height_m{};  // north-west, north-east, south-west, south-east
    std::array<PostClass, 4> post_class{};
};

/// u east, v south, 0..1.
std::array<double, 4> weights_at(double u, double v) {
    if (u + v <= 1) return {1 - u - v, u, v, 0};
    return {0, 1 - v, 1 - u, u + v - 1};
}

struct Interpolated {
    float height_m;
    PostClass post_class;
};

Interpolated interpolate(const CoarseCell& cell, const std::array<double, 4>& weights) {
    double height = 0;
    bool is_void = false, is_outside = false, is_land = false;
    for (std::size_t n = 0; n < 4; ++n) {
        if (weights[n] <= 0) continue;
        height += weights[n] * cell.height_m[n];
        is_void = is_void || cell.post_class[n] == PostClass::void_;
        is_outside = is_outside || cell.post_class[n] == PostClass::outside;
        is_land = is_land || cell.post_class[n] == PostClass::land;
    }
    if (is_outside) return {0, PostClass::outside};
    return {static_cast<float>(height), is_void ? PostClass::void_ : is_land ? PostClass::land : PostClass::sea};
}

/// Towards minus infinity, also of negative numbers.
std::int64_t floor_shift(std::int64_t value, std::uint32_t shift) { return value >> shift; }

LatticeWindow coarse_window(const LatticeWindow& fine, std::uint32_t shift) {
    LatticeWindow window;
    window.i0 = floor_shift(fine.i0, shift);
    window.j0 = floor_shift(fine.j0, shift);
    window.columns = static_cast<std::uint32_t>(floor_shift(fine.i0 + fine.columns - 1, shift) - window.i0 + 2);
    window.rows = static_cast<std::uint32_t>(floor_shift(fine.j0 + fine.rows - 1, shift) - window.j0 + 2);
    return window;
}

}  // namespace

void interpolate_posts(const PostsFile& coarse, std::uint32_t shift, LatticeWindow& fine) {
    LatticeWindow from = coarse_window(fine, shift);
    coarse.read(from);
    fine.height_m.resize(std::size_t{fine.columns} * fine.rows);
    fine.post_class.resize(fine.height_m.size());
    const double side = 1u << shift;
    for (std::int64_t j = fine.j0; j < fine.j0 + fine.rows; ++j)
        for (std::int64_t i = fine.i0; i < fine.i0 + fine.columns; ++i) {
            const std::int64_t a = floor_shift(i, shift), b = floor_shift(j, shift);
            CoarseCell cell;
            for (std::size_t n = 0; n < 4; ++n) {
                const std::size_t at = from.at(a + static_cast<std::int64_t>(n % 2), b + static_cast<std::int64_t>(n / 2));
                cell.height_m[n] = from.height_m[at];
                cell.post_class[n] = from.post_class[at];
            }
            const Interpolated post = interpolate(
                cell, weights_at(static_cast<double>(i - (a << shift)) / side, static_cast<double>(j - (b << shift)) / side));
            fine.height_m[fine.at(i, j)] = post.height_m;
            fine.post_class[fine.at(i, j)] = post.post_class;
        }
}

InsetPosts::InsetPosts(const PostsFile& coarse, std::uint32_t shift, const PostRange& region, const std::string& path)
    : coarse_(coarse),
      shift_(shift),
      region_(region),
      posts_(path, region.i1 - region.i0 + 1, region.j1 - region.j0 + 1, false) {}

void InsetPosts::read(LatticeWindow& window) const {
    const std::int64_t i0 = std::max<std::int64_t>(window.i0, region_.i0), j0 = std::max<std::int64_t>(window.j0, region_.j0);
    const std::int64_t i1 = std::min<std::int64_t>(window.i0 + window.columns - 1, region_.i1),
                       j1 = std::min<std::int64_t>(window.j0 + window.rows - 1, region_.j1);
    LatticeWindow inside;
    inside.i0 = i0 - region_.i0;
    inside.j0 = j0 - region_.j0;
    inside.columns = static_cast<std::uint32_t>(std::max<std::int64_t>(i1 - i0 + 1, 0));
    inside.rows = static_cast<std::uint32_t>(std::max<std::int64_t>(j1 - j0 + 1, 0));
    if (inside.columns != window.columns || inside.rows != window.rows) interpolate_posts(coarse_, shift_, window);
    if (inside.columns == 0 || inside.rows == 0) return;
    posts_.read(inside);
    window.height_m.resize(std::size_t{window.columns} * window.rows);
    window.post_class.resize(window.height_m.size());
    for (std::int64_t j = j0; j <= j1; ++j) {
        const std::size_t from = inside.at(inside.i0, j - region_.j0), to = window.at(i0, j);
        std::copy_n(&inside.height_m[from], inside.columns, &window.height_m[to]);
        std::copy_n(&inside.post_class[from], inside.columns, &window.post_class[to]);
    }
}

void InsetPosts::write(const LatticeWindow& window) {
    posts_.write(static_cast<std::uint32_t>(window.i0 - region_.i0), static_cast<std::uint32_t>(window.j0 - region_.j0),
                 window.columns, window.rows, {window.height_m.data(), window.height_m.size()},
                 {window.post_class.data(), window.post_class.size()});
}

RegionBlocks::RegionBlocks(const PostRange& region, std::uint32_t base_level)
    : level_(base_level),
      first_i_(region.i0 / (kChunkCells << base_level)),
      first_j_(region.j0 / (kChunkCells << base_level)),
      across_((region.i1 - region.i0 + (kChunkCells << base_level) - 1) / (kChunkCells << base_level)),
      down_((region.j1 - region.j0 + (kChunkCells << base_level) - 1) / (kChunkCells << base_level)) {}

ChunkKey RegionBlocks::chunk(std::uint32_t block) const {
    return {level_, first_i_ + block % across_, first_j_ + block / across_};
}

}  // namespace tedavis::host_sim
