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
    /// The point of the summary, which is searched in the whole run, between its frames too; else of the run's frames the lowest
    /// in flight.
    bool is_of_summary = false;
    /// Of take-off and landing, and without a position or known ground, where it is of the summary.
    double left_out_s = 0, unknown_s = 0;

    [[nodiscard]] bool has_place() const { return std::isfinite(latitude_deg) && std::isfinite(longitude_deg); }
};

/// On the runway everything is close to the ground, and without a known phase it is not known who is on it.
[[nodiscard]] bool is_known_to_fly(const ComparedFrame& frame);

/// Of the run's summary where that has it. Nothing where no frame in flight knows its height either.
[[nodiscard]] std::optional<RunClosest> closest_of_run(const ComparedRun& run);

/// What was searched: "its whole run, between its frames too, without 30 s of take-off and landing".
[[nodiscard]] std::string searched_words(const RunClosest& closest);

}  // namespace tedavis::host_sim
