/// The whole state of playing a recorded flight: the position in the log, and the tracker's memory.
///
/// It is trivially copyable: a copy is a checkpoint, in memory or on disk, and playing from it gives the same bits as playing
/// from the log's start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "bus/tracker/flight_tracker.hpp"
#include "host_sim/replay/log_facts.hpp"

namespace tedavis::host_sim {

struct FlightProgress {
    bus::LogPosition position;
    bus::TrackerMemory tracker;
    InterfaceFrames frames_of{};  ///< number of frames given to the tracker, by interface
    std::size_t next_edge = 0;
    std::uint64_t steps_run = 0;  ///< steps of the tracker's grid, without those skipped in gaps
    base::Time reached;
    base::Time newest_frame;  ///< receive stamp of the last frame fed
};
static_assert(std::is_trivially_copyable_v<FlightProgress>);

}  // namespace tedavis::host_sim
