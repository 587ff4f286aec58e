/// Where a run came closest to the terrain: `closest` of the summary.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/clearance/closest_points.hpp"
#include "render_core/policy/display_decisions.hpp"

namespace tedavis::host_sim {

/// The frame of a run that is next to a closest point in time.
struct FrameBeside {
    std::uint64_t frame = 0;
    double time_s = 0;  ///< since the log's first frame
    policy::TerrainAhead alert = policy::TerrainAhead::none;
    std::string design;
    std::string picture;    ///< path in the run's folder; empty where none is kept
    std::string small_png;  ///< for the report; empty unless the frame was drawn for a closest point
};

struct StatedClosest {
    ClosestPoint point;
    double time_s = 0;  ///< since the log's first frame
    std::string utc;    ///< with tenths of seconds; empty where no date is known
    FrameBeside frame;
};

struct ClosestReport {
    bool is_searched = false;      ///< false: there is no terrain, or the run was interrupted
    bool assumes_heights = false;  ///< geometric heights of the log are pressure altitudes (`convert --assume-geometric`)
    double sample_step_s = 0;      ///< between the samples of the track
    double left_out_s = 0;         ///< of take-off and landing
    double unknown_s = 0;          ///< without a position or without known ground
    std::vector<StatedClosest> by_height, by_distance;
    std::vector<TrackSample> track;  ///< for the profile
};

/// "14:23:05.2 UTC", or "at 83.2 s" where no date is known.
[[nodiscard]] std::string when_text(const StatedClosest& closest);
/// "none", "caution", "warning".
[[nodiscard]] const char* alert_level_text(policy::TerrainAhead level);
/// Null where is_searched is false.
[[nodiscard]] nlohmann::ordered_json closest_json(const ClosestReport& report);

}  // namespace tedavis::host_sim
