#include "render_core/flight/phase_monitor.hpp"

namespace tedavis::flight {

PhaseStatus PhaseMonitor::step(const AircraftState& aircraft, PhaseInputs inputs, base::Time now) {
    inputs.motion = detect_motion_phase(aircraft, now, settings_.motion, motion_);
    if (settings_.stated.stated) inputs.switches = settings_.stated;
    status_ = arbitrate_phase(inputs, now, settings_.arbiter, arbiter_);
    follow_phase(status_, now, presented_);
    return status_;
}

}  // namespace tedavis::flight
