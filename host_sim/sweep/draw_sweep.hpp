/// Draws a place from viewpoints round it, on one display, and measures each picture.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/sweep/swept_views.hpp"
#include "host_sim/written_files.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

/// A place in the user's units.
struct SweptPlace {
    double latitude_deg = 0, longitude_deg = 0;
    std::optional<double> altitude_msl_m;  ///< nothing: the ground's
};

struct SweepJob {
    PictureOptions picture;                ///< with terrain
    std::string terrain_name, scene_name;  ///< their names in messages and results
    std::optional<SweptPlace> place;       ///< nothing: the middle of the terrain
    double radius_m = 250;                 ///< radius of the place
    SweepRings rings;
    flight::PhaseStatus phase;
    base::Time time = kPosedTime;
    bool layers = false;               ///< writes layer masks beside the pictures
    std::string folder;                ///< existing folder for the pictures, and for all views of those that stand out
    std::function<bool()> is_stopped;  ///< called before each picture
};

/// Least height of a viewpoint above the ground; lower ones are not drawn.
inline constexpr double kMinClearance_m = 5;

/// Draws the sweep; `fault` receives a sentence where a part of the terrain failed. When stopped, it returns the views so far;
/// throws Interrupted where there are none, and UserError where nothing can be seen from any viewpoint.
[[nodiscard]] Sweep draw_sweep(const SweepJob& job, WrittenFiles& files, Console& console, std::string& fault);

}  // namespace tedavis::host_sim
