/// Determines the flight phase in effect from motion, bus and switches, in fixed steps.
///
/// The result depends on the steps, so both programs step it every kStep of the source's time, whatever the frame rate. A
/// replay that starts in the middle passes through the same steps as a whole run. Plain data; a copy is a checkpoint.
#pragma once

#include "render_core/flight/motion_phase_detector.hpp"
#include "render_core/flight/phase_arbiter.hpp"
#include "render_core/flight/presented_phase.hpp"

namespace tedavis::flight {

struct PhaseSettings {
    MotionPhaseSettings motion;
    PhaseArbiterSettings arbiter;
    /// A phase that holds as if a switch stated it, whatever the panel says, for a desk; not stated: the panel's.
    PhaseStatement stated;
};

class PhaseMonitor {
public:
    static constexpr base::Duration kStep = base::Duration::milliseconds(20);

    explicit PhaseMonitor(const PhaseSettings& settings = PhaseSettings()) : settings_(settings) {}

    /// `aircraft` contains height_above_terrain where it is known. `inputs.motion` is filled in by step().
    PhaseStatus step(const AircraftState& aircraft, PhaseInputs inputs, base::Time now);
    [[nodiscard]] const PhaseStatus& status() const { return status_; }

private:
    PhaseSettings settings_;
    MotionPhaseState motion_;
    PhaseArbiterState arbiter_;
    PresentedPhaseState presented_;
    PhaseStatus status_;
};
static_assert(std::is_trivially_copyable_v<PhaseMonitor>);

}  // namespace tedavis::flight
