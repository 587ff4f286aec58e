/// Points and boxes on the screen: pixels, origin at the top-left corner of the top-left pixel, y down.
#pragma once

#include <type_traits>

namespace tedavis::draw {

struct Point {
    float x = 0, y = 0;
};

struct Rect {
    float x = 0, y = 0, width = 0, height = 0;

    [[nodiscard]] constexpr float right() const { return x + width; }
    [[nodiscard]] constexpr float bottom() const { return y + height; }
    [[nodiscard]] constexpr Point center() const { return {x + width / 2, y + height / 2}; }
    [[nodiscard]] constexpr bool empty() const { return !(width > 0 && height > 0); }
    [[nodiscard]] constexpr bool contains(Point p) const { return p.x >= x && p.x <= right() && p.y >= y && p.y <= bottom(); }
    [[nodiscard]] constexpr bool contains(const Rect& r) const {
        return r.x >= x && r.y >= y && r.right() <= right() && r.bottom() <= bottom();
    }
    /// Boxes that only touch do not overlap.
    [[nodiscard]] constexpr bool overlaps(const Rect& r) const {
        return x < r.right() && r.x < right() && y < r.bottom() && r.y < bottom();
    }
    [[nodiscard]] constexpr Rect shrunk(float by) const { return {x + by, y + by, width - 2 * by, height - 2 * by}; }
};
static_assert(std::is_trivially_copyable_v<Rect>);

}  // namespace tedavis::draw
