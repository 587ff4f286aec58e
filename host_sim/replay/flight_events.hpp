/// The instants of a flight at which something happens, so that a run that draws few frames has one there.
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

/// Told how far a look ahead has come, now and then; may throw to end it.
using ReachedTime = std::function<void(base::Time time)>;

/// The first intervals of terrain alerts in these parts of the flight, of which there is at least one: with a caution after none,
/// or with a warning after less. Decides all intervals from the log's start on that no earlier run has left (interval_store.hpp);
/// a run to the last part's end does so as well.
[[nodiscard]] std::vector<base::Time> alert_instants(FramePreroll& preroll, const TimeRanges& parts,
                                                     const ReachedTime& reached = nullptr);

/// Beginnings of alerts and changes of the flight phase, in order of time. Of more than `most`, alerts come before changes of the
/// phase, and of each kind they are some, evenly by their number.
[[nodiscard]] std::vector<base::Time> event_instants(FlightPlayer& player, FramePreroll& preroll, const TimeRanges& parts,
                                                     std::uint64_t most, const ReachedTime& reached = nullptr);

}  // namespace tedavis::host_sim
