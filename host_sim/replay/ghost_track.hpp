/// The moments of another flight, aligned with those of the own one.
#pragma once

#include <optional>
#include <vector>

#include "host_sim/options/ghost_options.hpp"
#include "host_sim/replay/scanned_flight.hpp"

namespace tedavis::host_sim {

/// By place, the other flight is shown where it comes within so many metres of the own one.
inline constexpr double kGhostWithin_m = 3000;

struct GhostTrack {
    std::vector<ScannedPlace> places;  ///< `time` is the own log's; ascending; at least two, and at least one joins the next
    std::optional<double> shift_s;     ///< as ShownGhost::shift_s
};

/// Throws UserError where no moment of the ghost belongs to one of the own flight; the sentence names what may be tried.
[[nodiscard]] GhostTrack ghost_track(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align);

}  // namespace tedavis::host_sim
