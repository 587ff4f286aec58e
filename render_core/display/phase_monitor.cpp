#include "render_core/display/phase_monitor.hpp"

namespace tedavis::display {

flight::PhaseStatus PhaseMonitor::step(const flight::AircraftState& aircraft, flight::PhaseInputs inputs, base::Time now) {
    inputs.motion = flight::detect_motion_phase(aircraft, now, motion_settings_, motion_);
    status_ = flight::arbitrate_phase(inputs, now, arbiter_settings_, arbiter_);
    flight::follow_phase(status_, now, presented_);
    return status_;
}

}  // namespace tedavis::display
