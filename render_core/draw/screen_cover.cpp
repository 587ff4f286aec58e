#include "render_core/draw/screen_cover.hpp"

#include <algorithm>

namespace tedavis::draw {
namespace {

/// Widens [low, high] by the part of an edge that lies between two heights.
void include_edge(const Point& a, const Point& b, float top, float bottom, float& low, float& high) {
    const float first = std::max(std::min(a.y, b.y), top), last = std::min(std::max(a.y, b.y), bottom);
    if (first > last) return;
    for (const float y : {first, last}) {
        const float x = a.y == b.y ? a.x : a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        low = std::min(low, x);
        high = std::max(high, x);
    }
    if (a.y != b.y) return;
    low = std::min(low, b.x);
    high = std::max(high, b.x);
}

}  // namespace

void ScreenCover::clear(std::uint32_t width, std::uint32_t height, float cell_px) {
    cell_px_ = std::max(cell_px, static_cast<float>(std::max(width, height)) / kMaxCells);
    rows_ = {};
}

int ScreenCover::cell_of(float px) const { return static_cast<int>(std::clamp(px / cell_px_, 0.0f, kMaxCells - 1.0f)); }

ScreenCover::Row ScreenCover::span(int first, int last) {
    const auto below = [](int n) { return n >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << std::max(n, 0)) - 1; };
    return {below(last + 1) & ~below(first), below(last + 1 - 64) & ~below(first - 64)};
}

void ScreenCover::take(const QuadBatch& batch, float right_px) {
    const auto vertices = batch.vertices();
    const auto indices = batch.indices();
    for (std::size_t n = 0; n + 2 < indices.size(); n += 3) {
        Point corner[3];
        for (std::size_t k = 0; k < 3; ++k) corner[k] = {vertices[indices[n + k]].x + right_px, vertices[indices[n + k]].y};
        take_triangle(corner);
    }
}

void ScreenCover::take_triangle(const Point (&corner)[3]) {
    const float top = std::min({corner[0].y, corner[1].y, corner[2].y}),
                bottom = std::max({corner[0].y, corner[1].y, corner[2].y});
    const int last = cell_of(bottom);
    for (int row = cell_of(top); row <= last; ++row) {
        const float upper = row == 0 ? top : cell_px_ * static_cast<float>(row);
        const float lower = row == kMaxCells - 1 ? bottom : cell_px_ * static_cast<float>(row + 1);
        float low = 1e9f, high = -1e9f;
        for (std::size_t k = 0; k < 3; ++k) include_edge(corner[k], corner[(k + 1) % 3], upper, lower, low, high);
        if (low > high) continue;
        const Row taken = span(cell_of(low), cell_of(high));
        for (std::size_t part = 0; part < taken.size(); ++part) rows_[static_cast<std::size_t>(row)][part] |= taken[part];
    }
}

bool ScreenCover::is_free(const Rect& box) const {
    const Row wanted = span(cell_of(box.x), cell_of(box.right()));
    for (int row = cell_of(box.y); row <= cell_of(box.bottom()); ++row)
        for (std::size_t part = 0; part < wanted.size(); ++part)
            if ((rows_[static_cast<std::size_t>(row)][part] & wanted[part]) != 0) return false;
    return true;
}

}  // namespace tedavis::draw
