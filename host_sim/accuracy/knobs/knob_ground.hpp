/// What knobs are measured on.
#pragma once

#include "host_sim/tracing/traced_ground.hpp"

namespace tedavis::host_sim {

/// The ground must outlive the knobs.
struct KnobGround {
    const TracedGround& ground;
    bool is_quick = false;  ///< fewer samples
};

}  // namespace tedavis::host_sim
