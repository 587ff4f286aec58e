/// The track of another flight with times of the own one.
#pragma once

#include <optional>
#include <vector>

#include "host_sim/options/ghost_options.hpp"
#include "host_sim/replay/scanned_flight.hpp"

namespace tedavis::host_sim {

/// With GhostAlign::place, the other flight is shown where it is at most this far from the own one.
inline constexpr double kGhostWithin_m = 3000;

struct GhostTrack {
    std::vector<ScannedPlace> places;  ///< with times of the own log, ascending; at least two, and at least one joins the next
    std::optional<double> shift_s;     ///< as ShownGhost::shift_s
};

/// Throws UserError where no time of the ghost is aligned with a time of the own flight; the message suggests other options.
[[nodiscard]] GhostTrack ghost_track(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align);

}  // namespace tedavis::host_sim
