/// The aircraft as bus and switches state it: the one loop that both programs, the self-test and the tests run.
///
/// Frames and switch edges are read up to each step of a fixed grid of the source's time (flight::PhaseMonitor::kStep). A step
/// reads the aircraft, asks for its height above the terrain, and moves phase and trail on. An input at T is what was received up
/// to T, with the phase of the last step at or before T, so it does not depend on how often anybody asked.
///
/// All that it remembers lies in one plain TrackerMemory; a copy is a checkpoint, and going on from it gives the same bits as the
/// run that it was copied from, where the sources go on from there too.
///
/// Thread  one. Memory  the caller's; nothing is allocated. Time  of the sources, from the caller; never back, but for a
/// checkpoint. Failure  a source that fails gives nothing; a panel that fails states no phase and raises the switch fault.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "bus/frame/can_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "bus/switches/switch_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "bus/tracker/frame_listener.hpp"
#include "render_core/flight/frame_input.hpp"
#include "render_core/flight/phase_monitor.hpp"
#include "render_core/flight/terrain_heights.hpp"

namespace tedavis::bus {

struct TrackerMemory {
    TrackerMemory() = default;
    /// `panel` null: there are no phase switches. `first_step` begins the grid.
    TrackerMemory(const BusSettings& settings, const SwitchConfig* panel, base::Time first_step);

    StateAssembler assembler;
    std::optional<SwitchToPhase> switches;
    flight::PhaseMonitor monitor;
    flight::FlightTrail trail;
    base::Time next_step;
};
static_assert(std::is_trivially_copyable_v<TrackerMemory>);

/// What a tracker reads, and who receives it too.
struct TrackerPorts {
    CanSource& can;
    SwitchSource* panel = nullptr;      ///< null: there are no phase switches
    FrameListener* listener = nullptr;  ///< null: nobody else does
    /// Of 256 frames a reading: more than a frame's worth of the fastest bus, and what is left waits for the next reading. Who
    /// reads a recording asks for all.
    std::uint32_t max_batches = 64;
};

class FlightTracker {
public:
    /// Further behind than this many steps the grid starts anew: a program that was halted goes on at once.
    static constexpr int kMaxSteps = 100;

    /// What is given must outlive it.
    FlightTracker(TrackerMemory& memory, const TrackerPorts& ports) : memory_(memory), ports_(ports) {}

    /// All steps up to `now`, and the input at `now`.
    [[nodiscard]] flight::FrameInput advance_to(base::Time now, flight::TerrainHeights& heights);

    /// Its parts, for whoever steps through a recording: the next step of the grid, ...
    void step(flight::TerrainHeights& heights);
    [[nodiscard]] base::Time next_step() const { return memory_.next_step; }
    /// ... the steps before `time` left out, for nothing can change in them, ...
    void skip_steps_before(base::Time time);
    /// ... and what is known at `now`, without a step.
    [[nodiscard]] flight::FrameInput input_at(base::Time now, flight::TerrainHeights& heights);

private:
    void read_until(base::Time time);
    void read_switches(base::Time time);
    [[nodiscard]] flight::PhaseInputs phase_inputs(const PhaseMessage& stated, base::Time time) const;

    TrackerMemory& memory_;
    TrackerPorts ports_;
};

}  // namespace tedavis::bus
