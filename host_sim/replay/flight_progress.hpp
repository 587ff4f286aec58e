/// All that changes while a recorded flight is played: how far the log is read, and what the tracker has made of it.
///
/// Plain bytes: a copy is a checkpoint, in memory or on disk, and playing on from it gives the same bits as a run from
/// the log's start.
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
    InterfaceFrames frames_of{};  ///< fed, by interface
    std::size_t next_edge = 0;
    std::uint64_t steps_run = 0;  ///< of the tracker's grid, but those where the recording pauses
    base::Time reached;
    base::Time newest_frame;  ///< receive stamp of the last frame fed
};
static_assert(std::is_trivially_copyable_v<FlightProgress>);

}  // namespace tedavis::host_sim
