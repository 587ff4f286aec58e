/// Where a run came closest to the ground below, in flight.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "host_sim/comparison/compared_run.hpp"

namespace tedavis::host_sim {

struct RunClosest {
    double height_m = 0;  ///< above the terrain
    double time_s = 0;    ///< since the log's first frame
    double latitude_deg = std::numeric_limits<double>::quiet_NaN(),
           longitude_deg = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known
    std::string phase;                                                ///< "approach.final"
    /// True: the closest point of the summary, which was searched in the whole run, also between frames; false: the frame in
    /// flight that is lowest above the terrain.
    bool is_of_summary = false;
    /// Times that were not searched, if it is of the summary: take-off and landing, and times without a position or known ground.
    double left_out_s = 0, unknown_s = 0;

    [[nodiscard]] bool has_place() const { return std::isfinite(latitude_deg) && std::isfinite(longitude_deg); }
};

/// True if the frame's phase is known and is neither ground, start of take-off nor landing: frames on the runway would all be
/// closest points.
[[nodiscard]] bool is_known_to_fly(const ComparedFrame& frame);

/// Returns the point of the run's summary, else of its frames; nothing where no frame in flight has a height above the terrain.
[[nodiscard]] std::optional<RunClosest> closest_of_run(const ComparedRun& run);

/// What was searched: "its whole run, between its frames too, without 30 s of take-off and landing".
[[nodiscard]] std::string searched_words(const RunClosest& closest);

}  // namespace tedavis::host_sim
