/// An image of one number per pixel, rows from the top without gaps. Owns nothing.
#pragma once

#include <cstddef>

#include "render_core/base/memory_budget.hpp"
#include "render_core/perception/picture_view.hpp"

namespace tedavis::perception {

struct Plane {
    float* values = nullptr;
    int width = 0, height = 0;

    [[nodiscard]] float* row(int y) const { return values + static_cast<std::ptrdiff_t>(y) * width; }
    [[nodiscard]] std::size_t size() const { return pixels_of(width, height); }
};

/// Allocates a plane; it has no values where the arena is too small.
[[nodiscard]] inline Plane allocate_plane(base::Arena& arena, int width, int height) {
    return {arena.allocate_array<float>(pixels_of(width, height)).data(), width, height};
}

/// Returns the side of a level at 1/2^level of the size, rounded up: its last pixel may extend beyond the picture.
[[nodiscard]] constexpr int level_side(int side, int level) { return (side + (1 << level) - 1) >> level; }

}  // namespace tedavis::perception
