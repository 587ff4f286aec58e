/// The planes of a raster that make a grid: its times, its levels, and the number of members of an ensemble.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/scene_builder/grid_source.hpp"

namespace tedavis::host_sim {

struct GridAxes {
    std::vector<std::int64_t> times_ns;           ///< ascending; empty: the file states none
    std::vector<double> levels;                   ///< ascending, as the file states them; empty: none
    std::vector<std::vector<GridPlane>> members;  ///< of each time and level, time by time: [time * levels + level]

    [[nodiscard]] std::size_t time_count() const { return times_ns.empty() ? 1 : times_ns.size(); }
    [[nodiscard]] std::size_t level_count() const { return levels.empty() ? 1 : levels.size(); }
};

/// The selection of a file's planes.
struct PlaneChoice {
    std::optional<std::int64_t> from_ns, until_ns;  ///< both included
    std::vector<double> levels;                     ///< as the file states them; empty: all
    bool has_members = false;                       ///< planes of the same time and level are members of an ensemble
};

/// Returns the time at which the data were measured or computed. For several times it is the last time of computation that the
/// file states, else the last of the times. For a single time it is this time, from which the age counts. Nothing where the file
/// states none.
[[nodiscard]] std::optional<std::int64_t> data_time_of(const GridAxes& axes);

/// Throws UserError, beginning with `file`, where no plane is selected, a level is missing at a time, or several planes have the
/// same time and level although the recipe has no members; the message names the existing levels and times.
[[nodiscard]] GridAxes sort_planes(const std::vector<GridPlane>& planes, const PlaneChoice& choice, const std::string& file);

}  // namespace tedavis::host_sim
