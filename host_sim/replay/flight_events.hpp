/// Times of alerts and phase changes of a flight, so that a run of few frames has a frame at each of them.
///
/// Further kinds of events (closest points, for instance) are added in event_instants().
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/frame_preroll.hpp"
#include "host_sim/replay/time_range.hpp"

namespace tedavis::host_sim {

/// Called now and then with the time that a search has reached; may throw to end it.
using ReachedTime = std::function<void(base::Time time)>;

/// Returns the begins of the decision intervals in these parts of the flight, at least one part, in which the terrain alert
/// rises: to a caution, or to a warning. Decides all intervals from the log's start to the last part's end that no earlier run
/// has stored (interval_store.hpp), as a run to that end does.
[[nodiscard]] std::vector<base::Time> alert_instants(FramePreroll& preroll, const TimeRanges& parts,
                                                     const ReachedTime& reached = nullptr);

/// Returns the times of rising alerts and of phase changes, at most `most`, ascending. Alerts have precedence over phase changes;
/// of a kind with too many, every n-th is taken.
[[nodiscard]] std::vector<base::Time> event_instants(FlightPlayer& player, FramePreroll& preroll, const TimeRanges& parts,
                                                     std::uint64_t most, const ReachedTime& reached = nullptr);

}  // namespace tedavis::host_sim
