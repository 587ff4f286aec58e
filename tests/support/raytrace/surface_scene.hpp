/// Heights with the mipmap that bounds a surface over them.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "render_core/raytrace/search/trace_surface.hpp"
#include "render_core/raytrace/surface/surface_bounds.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::test_support {

template <class Height>
struct SurfaceScene {
    HeldHeights<Height> heights;
    raytrace::SurfaceSettings settings;
    std::vector<unsigned char> memory;
    base::Arena arena;
    raytrace::HeightMipmap<Height> maxima;

    SurfaceScene(HeldHeights<Height> held, const raytrace::SurfaceSettings& surface)
        : heights(std::move(held)), settings(surface) {
        const auto grid = heights.grid();
        memory.resize(raytrace::HeightMipmap<Height>::bytes_needed(grid.columns, grid.rows));
        arena = base::Arena(memory.data(), memory.size());
        EXPECT_TRUE(maxima.start(grid, arena, raytrace::surface_bounds<Height>(settings)));
        base::SerialWorkers alone;
        maxima.build(alone);
    }
    SurfaceScene(HeldHeights<Height> held, raytrace::SurfaceKind kind) : SurfaceScene(std::move(held), settings_of(kind)) {}
    SurfaceScene(const SurfaceScene&) = delete;
    SurfaceScene& operator=(const SurfaceScene&) = delete;

    [[nodiscard]] raytrace::SurfaceHit trace(const raytrace::Ray& ray, raytrace::TraceCounts* counts = nullptr) const {
        return raytrace::trace_surface(maxima, settings, ray, counts);
    }

    static raytrace::SurfaceSettings settings_of(raytrace::SurfaceKind kind) {
        raytrace::SurfaceSettings made;
        made.kind = kind;
        return made;
    }
};

inline constexpr raytrace::SurfaceKind kSurfaceKinds[] = {raytrace::SurfaceKind::two_triangles, raytrace::SurfaceKind::bilinear,
                                                          raytrace::SurfaceKind::bicubic,
                                                          raytrace::SurfaceKind::approximate_bicubic};

}  // namespace tedavis::test_support
