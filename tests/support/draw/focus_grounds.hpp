/// Ground with foci, for tests: a white design, foci of regions over a raster.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/terrain/chunk_drawing.hpp"

namespace tedavis::test_support {

inline constexpr double kFocusGround_m = 1000;

inline design::DesignSettings white_design() {
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.warning_colors = false;
    return design;
}

/// As many foci as regions, of their shapes.
inline void ask_for(design::DesignSettings& design, const scene::FocusRegions& regions) {
    for (const scene::FocusRegion& region : regions) {
        design::FocusSettings focus;
        focus.shape = region.kind == scene::FocusPoints::path ? design::FocusShape::path
                      : region.is_square                      ? design::FocusShape::square
                                                              : design::FocusShape::circle;
        focus.context = region.context;
        focus.terrain.brightness = 0.25;
        ASSERT_TRUE(design.foci.try_push_back(focus));
    }
}

inline scene::FocusRegion region_over(const RasterScene& scene, double i, double j) {
    const earth::Geodetic at = scene.place(i, j, kFocusGround_m);
    scene::FocusRegion region = scene::focus_region_at(at.latitude_rad, at.longitude_rad);
    region.point_count = 1;
    region.radius_m = 1500;
    region.context.width_m = 2000;
    return region;
}

inline void make_path(scene::FocusRegion& region, std::uint32_t points) {
    region.kind = scene::FocusPoints::path;
    region.point_count = points;
    region.radius_m = 300;
    for (std::uint32_t n = 0; n < points; ++n) region.points[n] = {-3000 + 6000.0 * n / (points - 1), 1500 * std::sin(2.4 * n)};
}

}  // namespace tedavis::test_support
