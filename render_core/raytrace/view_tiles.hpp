/// The tiles of a picture, which kernels trace one at a time (view_kernels.hpp).
#pragma once

#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

/// The numbers of tiles across and down a picture; tiles are numbered row by row.
struct ViewTiles {
    std::uint32_t across, down;

    ViewTiles(std::uint32_t width, std::uint32_t height)
        : across((width + kTileWidth - 1) / kTileWidth), down((height + kTileHeight - 1) / kTileHeight) {}
    [[nodiscard]] std::uint32_t count() const { return across * down; }
    [[nodiscard]] std::uint32_t left(std::uint32_t tile) const { return tile % across * kTileWidth; }
    [[nodiscard]] std::uint32_t top(std::uint32_t tile) const { return tile / across * kTileHeight; }
};

}  // namespace tedavis::raytrace
