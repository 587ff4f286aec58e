/// Assigns places of one track to another one.
///
/// The assignment does not go back along the other track, so that a holding pattern or a second pass does not make it jump to and
/// fro. Of all such assignments it is the one with the least sum of squared distances, each counted as `within_m` at most; where
/// several are equal, the one that is furthest back. It is found by dynamic programming over the segments of the other track.
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
    double along = 0;       ///< on the other track: 3.25 is a quarter of the way from its place 3 to its place 4
    double distance_m = 0;  ///< to there, along the ground
};

/// For each place of `track` its counterpart on `other`; nothing where that is more than `within_m` away. Memory and time grow
/// with the product of both lengths.
[[nodiscard]] std::vector<std::optional<PlacePair>> paired_places(const std::vector<TrackPlace>& track,
                                                                  const std::vector<TrackPlace>& other, double within_m);

}  // namespace tedavis::host_sim
