/// Effects on the finished picture of the scene, before symbology is laid over it: table [effects] of a design file.
///
///     [effects]
///     antialiasing = true
///     [effects.depth_of_field]
///     blur_px = 5                 # radius of the blur of what is infinitely far
///     focus_near_m = 2000         # sharp from here
///     focus_far_m = 15000         # to here, from the eye
///     focus_role = "storm_cell"   # instead: as far as the shown layers of this role reach
///     layers = "all"              # or "terrain", "data": what is blurred; the others stay sharp
///
/// Plain data; pixels of the picture, metres. Reading: start-up only, faults go to the section.
#pragma once

#include "render_core/base/config_reader.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

inline constexpr double kMostBlur_px = 8;

struct DepthOfField {
    double blur_px = 0;  ///< 0: everything is sharp
    double focus_near_m = 0, focus_far_m = 10'000;
    scene::LayerRole focus_role = scene::LayerRole::count;  ///< not count: what is in focus is a part of the data
    bool on_terrain = true, on_data = true;
};

struct ViewEffects {
    bool antialiasing = false;
    DepthOfField depth_of_field;
};

void read_view_effects(base::ConfigSection section, ViewEffects& effects);

}  // namespace tedavis::design
