/// The tracer's contact sheet: its presets and single operators over one view, with the cost of each and its difference from the
/// best.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host_sim/measure/picture_difference.hpp"
#include "host_sim/tracing/traced_shot.hpp"

namespace tedavis::host_sim {

struct TraceSheet {
    struct Picture {
        std::string title, file;
        raytrace::TraceSettings settings;
        TracedShot shot;
        PictureDifference from_quality;  ///< to the picture of the quality preset
    };
    struct Group {
        std::string title;
        std::vector<Picture> pictures;
    };
    std::string terrain;
    AircraftPose pose;
    std::uint32_t workers = 1;
    std::vector<Group> groups;  ///< presets first, of which the last is quality
};

/// Returns the sheet without pictures. Operators are changed one by one in the preset `time`.
[[nodiscard]] TraceSheet plan_trace_sheet();
/// Draws the pictures. `drawn` is called after each one; it may throw to stop. Throws UserError.
void draw_trace_sheet(TraceSheet& sheet, const TracedGround& ground, const TracedShotPlan& plan, base::Workers& workers,
                      const std::function<void(std::size_t done, std::size_t all)>& drawn);

}  // namespace tedavis::host_sim
