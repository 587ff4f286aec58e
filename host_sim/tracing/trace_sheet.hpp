/// The tracer's contact sheet: its presets and single operators over one view, with what each costs and how far it is from the
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

/// Without pictures: what will be drawn. Operators are changed one by one in the preset of time.
[[nodiscard]] TraceSheet plan_trace_sheet();
/// `drawn` is told of each picture; it may throw to stop. Throws UserError.
void draw_trace_sheet(TraceSheet& sheet, const TracedGround& ground, const TracedShotPlan& plan, base::Workers& workers,
                      const std::function<void(std::size_t done, std::size_t all)>& drawn);

}  // namespace tedavis::host_sim
