/// The inputs over which knobs are measured: ground, flight and display.
#pragma once

#include "host_sim/accuracy/knobs/flown_display.hpp"
#include "host_sim/accuracy/knobs/recorded_poses.hpp"
#include "host_sim/tracing/traced_ground.hpp"

namespace tedavis::host_sim {

/// The ground and the recorded flight must outlive the knobs.
struct KnobGround {
    const TracedGround& ground;
    bool is_quick = false;                    ///< fewer samples
    const RecordedPoses* recorded = nullptr;  ///< the flight that knobs fly; null: the shipped default flight
    FlownDisplay display = {};
};

}  // namespace tedavis::host_sim
