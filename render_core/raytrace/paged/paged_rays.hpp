/// The rays to be traced by a paged tracer: those of a picture, or any rays. Borrowed.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/view_tiles.hpp"

namespace tedavis::raytrace {

struct PagedRays {
    /// For a picture, whose rays are row by row of pixels: one camera, or one for each of its tiles (ViewTiles). Empty: the
    /// rays are `single`.
    base::Span<const GridCamera> cameras;
    std::uint32_t width = 0, height = 0;
    RaySpan span{};
    base::Span<const Ray> single{};
    bool goes_on = false;  ///< rays that already have a hit are not traced; false: all hits are cleared first

    [[nodiscard]] static PagedRays of(const GridCamera& camera, std::uint32_t width, std::uint32_t height) {
        return {{&camera, 1}, width, height};
    }
    [[nodiscard]] static PagedRays of(base::Span<const Ray> rays) {
        PagedRays all;
        all.single = rays;
        return all;
    }
    [[nodiscard]] std::uint32_t count() const {
        return cameras.empty() ? static_cast<std::uint32_t>(single.size()) : width * height;
    }
    [[nodiscard]] bool have_one_origin() const { return cameras.size() == 1; }
    [[nodiscard]] Ray at(std::uint32_t n) const {
        if (cameras.empty()) return single[n];
        const std::uint32_t x = n % width, y = n / width;
        const std::size_t tile =
            cameras.size() == 1 ? 0 : std::size_t{y / kTileHeight} * ViewTiles(width, height).across + x / kTileWidth;
        Ray ray = cameras[tile].ray(x, y);
        ray.from = span.from;
        ray.to = span.to;
        ray.gap = span.gap;
        return ray;
    }
};

}  // namespace tedavis::raytrace
