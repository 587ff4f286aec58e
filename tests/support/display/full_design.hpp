/// A design that asks for most effects.
#pragma once

#include "render_core/design/design_settings.hpp"

namespace tedavis::test_support {

inline design::DesignSettings design_with_everything() {
    design::DesignSettings design;
    design.terrain.style.sketch.silhouettes = 0.7;
    design.terrain.style.sketch.ridges = 0.2;
    design.terrain.style.shade.follows_sun = true;
    design.terrain.style.texture = design::TerrainTexture::image;
    design.sky.haze_distance_m = 50'000;
    design.terrain.style.grid.spacing_m = 1000;
    design.data.ground.is_shown = design.data.adjacent.is_shown = true;
    design::FocusSettings focus;
    focus.terrain.brightness = 0.4;
    focus.terrain.blur_px = 6;
    static_cast<void>(design.foci.try_push_back(focus));
    return design;
}

}  // namespace tedavis::test_support
