/// Runs of a comparison, made in memory.
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "host_sim/comparison/compared_run.hpp"

namespace tedavis::host_sim {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kDegree_m = 111194.93;  ///< of latitude, on a sphere of the mean radius of 6371 km

/// A frame at a place: metres north and east of 46 N, 9 E.
inline ComparedFrame made_frame(std::uint64_t number, double time_s, double north_m, double east_m) {
    ComparedFrame frame;
    frame.frame = number;
    frame.time_s = time_s;
    frame.hash = "5f";
    frame.phase = "cruise";
    frame.has_place = true;
    frame.latitude_deg = 46 + north_m / kDegree_m;
    frame.longitude_deg = 9 + east_m / kDegree_m / std::cos(46 * 3.14159265358979 / 180);
    frame.values = {1000, 400, 300, 5, 1, 20, 2, kUnknown, 30};
    frame.effects = {"fog", "shadow"};
    return frame;
}

/// Frames a step apart that fly north at 50 m/s.
inline ComparedRun made_run(const std::string& name, std::size_t frames, double first_s = 0, double step_s = 1) {
    ComparedRun run;
    run.folder = name;
    run.log = name + ".log";
    run.size = "960x540";
    for (std::size_t n = 0; n < frames; ++n) {
        const double time_s = first_s + step_s * static_cast<double>(n);
        run.frames.push_back(made_frame(n, time_s, 50 * time_s, 0));
    }
    return run;
}

/// The same flight as another run's.
inline ComparedRun with_log(ComparedRun run, const std::string& log) {
    run.log = log;
    return run;
}

}  // namespace tedavis::host_sim
