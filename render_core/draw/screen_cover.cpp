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

/// Whether three corners, the first and the last opposite ones, are those of an upright box.
bool is_half_of_box(const Point (&corner)[3]) {
    const Point &first = corner[0], &middle = corner[1], &last = corner[2];
    return (middle.y == first.y && middle.x == last.x) || (middle.x == first.x && middle.y == last.y);
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
    const auto corner = [&](std::size_t n) { return Point{vertices[indices[n]].x + right_px, vertices[indices[n]].y}; };
    for (std::size_t n = 0; n + 2 < indices.size(); n += 3) {
        const Point corners[] = {corner(n), corner(n + 1), corner(n + 2)};
        if (is_half_of_box(corners) && n + 5 < indices.size() && indices[n + 3] == indices[n] &&
            indices[n + 4] == indices[n + 2] && is_half_of_box({corners[0], corner(n + 5), corners[2]})) {
            take_box(corners[0], corners[2]);
            n += 3;
        } else {
            take_triangle(corners);
        }
    }
}

/// The cells that both halves of the box take.
void ScreenCover::take_box(const Point& first, const Point& opposite) {
    const auto [top, bottom] = std::minmax(first.y, opposite.y);
    const auto [low, high] = std::minmax(first.x, opposite.x);
    const int last = cell_of(bottom);
    for (int row = cell_of(top); row <= last; ++row) take_row(row, low, high);
}

void ScreenCover::take_row(int row, float low, float high) {
    const Row taken = span(cell_of(low), cell_of(high));
    for (std::size_t part = 0; part < taken.size(); ++part) rows_[static_cast<std::size_t>(row)][part] |= taken[part];
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
        if (low <= high) take_row(row, low, high);
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
