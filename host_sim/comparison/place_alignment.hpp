/// Assigns places of one track to another one.
///
/// The assigned places never go back along the other track, so that they do not jump to and fro in a holding pattern or at a
/// second pass. Of all such assignments the one with the least sum of squared distances is chosen, each limited to `within_m`; of
/// several equal ones, the one that is earliest on the other track. It is found by dynamic programming over the segments of the
/// other track.
#pragma once

#include <optional>
#include <vector>

namespace tedavis::host_sim {

/// A place of a track.
struct TrackPlace {
    double latitude_deg = 0, longitude_deg = 0;
    bool joins_next = true;  ///< false: the track has a gap behind it
};

struct PlacePair {
    double along = 0;       ///< fractional index on the other track: 3.25 is a quarter of the way from its place 3 to its place 4
    double distance_m = 0;  ///< distance to that place, along the ground
};

/// For each place of `track` its counterpart on `other`; nothing where that is more than `within_m` away. Memory and time grow
/// with the product of both lengths.
[[nodiscard]] std::vector<std::optional<PlacePair>> paired_places(const std::vector<TrackPlace>& track,
                                                                  const std::vector<TrackPlace>& other, double within_m);

}  // namespace tedavis::host_sim
