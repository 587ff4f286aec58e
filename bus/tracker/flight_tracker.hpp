/// Tracks the aircraft from bus and switches: the one loop that both programs, the self-test and the tests run.
///
/// Frames and switch edges are read up to each step of a fixed grid of the source's time (flight::PhaseMonitor::kStep). A step
/// takes a snapshot of the aircraft, requests its height above the terrain, and advances phase, trail and airspeed trend. An
/// input at T holds what was received up to T and the phase of the last step at or before T, so it does not depend on how often
/// inputs are requested. It also says which legend the panel or, where the panel does not, the bus asks for.
///
/// The whole state is one plain TrackerMemory. A copy is a checkpoint: continuing from it, with sources at the same position,
/// gives the same bits as the run that it was copied from.
///
/// Thread  one. Memory  the caller's; nothing is allocated. Time  the sources' time, passed by the caller; it never decreases
/// unless a checkpoint is restored. Failure  a source that fails delivers nothing; a panel that fails states no phase and
/// raises the switch fault.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include "bus/frame/can_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "bus/switches/switch_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "bus/tracker/frame_listener.hpp"
#include "render_core/flight/airspeed_trend.hpp"
#include "render_core/flight/attitude_excursion.hpp"
#include "render_core/flight/frame_input.hpp"
#include "render_core/flight/phase_monitor.hpp"
#include "render_core/flight/terrain_heights.hpp"

namespace tedavis::bus {

struct TrackerMemory {
    TrackerMemory() = default;
    /// `panel` is null where there are no phase switches. `first_step` is the first step of the grid.
    TrackerMemory(const BusSettings& settings, const SwitchConfig* panel, base::Time first_step,
                  const flight::PhaseSettings& phases = flight::PhaseSettings());

    StateAssembler assembler;
    std::optional<SwitchToPhase> switches;
    flight::PhaseMonitor monitor;
    flight::FlightTrail trail;
    flight::AirspeedTrend airspeed;
    flight::AttitudeExcursion excursion;
    base::Time next_step;
};
static_assert(std::is_trivially_copyable_v<TrackerMemory>);

/// The sources that a tracker reads, and a listener that receives the frames as well.
struct TrackerPorts {
    CanSource& can;
    SwitchSource* panel = nullptr;      ///< null: there are no phase switches
    FrameListener* listener = nullptr;  ///< null: no listener
    /// Batches of 256 frames per reading. The default exceeds what the fastest bus sends between two display frames; the rest
    /// is read next time. A replay sets it high enough to read everything.
    std::uint32_t max_batches = 64;
};

class FlightTracker {
public:
    /// When it is more steps than this behind, the grid restarts at `now`, so that a program that was halted continues at once.
    static constexpr int kMaxSteps = 100;

    /// `memory` and the ports must outlive the tracker.
    FlightTracker(TrackerMemory& memory, const TrackerPorts& ports) : memory_(memory), ports_(ports) {}

    /// Runs all steps up to `now` and returns the input at `now`.
    [[nodiscard]] flight::FrameInput advance_to(base::Time now, flight::TerrainHeights& heights);

    /// The parts of advance_to(), for stepping through a recording. step() runs the next step of the grid.
    void step(flight::TerrainHeights& heights);
    [[nodiscard]] base::Time next_step() const { return memory_.next_step; }
    /// Skips the steps before `time`; the caller knows that nothing changes in them.
    void skip_steps_before(base::Time time);
    /// Returns the input at `now` without running a step.
    [[nodiscard]] flight::FrameInput input_at(base::Time now, flight::TerrainHeights& heights);

private:
    void read_until(base::Time time);
    void read_switches(base::Time time);
    [[nodiscard]] bool panel_asks_for_legend(base::Time time) const;
    [[nodiscard]] flight::PhaseInputs phase_inputs(const PhaseMessage& stated, base::Time time) const;

    static constexpr std::size_t kFramesAtOnce = 256;

    TrackerMemory& memory_;
    TrackerPorts ports_;
    CanFrame batch_[kFramesAtOnce];  ///< of one reading; its content is no part of the state
};

}  // namespace tedavis::bus
