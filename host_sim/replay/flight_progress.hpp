/// All that changes while a recorded flight is played: how far the log is read, what the bus has said, and the phase.
///
/// Plain bytes: a copy is a checkpoint, in memory or on disk, and playing on from it gives the same bits as a run from
/// the log's start.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "bus/switches/switch_to_phase.hpp"
#include "host_sim/replay/log_facts.hpp"
#include "render_core/display/phase_monitor.hpp"
#include "render_core/flight/flown_way.hpp"

namespace tedavis::host_sim {

struct FlightProgress {
    bus::LogPosition position;
    bus::StateAssembler assembler;
    InterfaceFrames frames_of{};                 ///< fed, by interface
    std::optional<bus::SwitchToPhase> switches;  ///< there from the start on; optional because it has no default
    std::size_t next_edge = 0;
    display::PhaseMonitor monitor;
    flight::FlownWay way;
    std::int64_t next_step = 0;   ///< of the phase's grid
    std::uint64_t steps_run = 0;  ///< fewer than next_step where the recording pauses
    base::Time reached;
    base::Time newest_frame;  ///< receive stamp of the last frame fed
};
static_assert(std::is_trivially_copyable_v<FlightProgress>);

}  // namespace tedavis::host_sim
