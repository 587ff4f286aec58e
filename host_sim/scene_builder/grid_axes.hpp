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

/// What of a file's planes is wanted.
struct PlaneChoice {
    std::optional<std::int64_t> from_ns, until_ns;  ///< both included
    std::vector<double> levels;                     ///< as the file states them; empty: all
    bool has_members = false;                       ///< planes of one time and level belong together
};

/// When they were measured or computed. Of planes of several times the last time for which the file states that one of them was
/// computed then; where it states none they are of their own times, and this is the last. A single time is that for which the
/// plane holds, as its age counts from there. Empty: the file states none.
[[nodiscard]] std::optional<std::int64_t> data_time_of(const GridAxes& axes);

/// Throws UserError, beginning with `file`, where none is left, a level is missing at a
/// time, or several planes share one while the recipe wants no members; the sentence names the levels and times that there are.
[[nodiscard]] GridAxes sort_planes(const std::vector<GridPlane>& planes, const PlaneChoice& choice, const std::string& file);

}  // namespace tedavis::host_sim
