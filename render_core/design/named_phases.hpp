/// Which design stands for which phase of flight, as the table [phases] of a design says.
///
///     [phases]
///     takeoff = "takeoff"                     # a scenario with all its phases: a name of configs/designs, or a path from this
///     file "go_around.replanning" = "replanning"   # one phase, which goes before its scenario
///
/// Phases that are not named have the design itself. A design that another one names has no such table.
#pragma once

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxNamedPhases = 16;  ///< more than there are

using DesignFileName = base::FixedString<127>;

struct NamedPhase {
    flight::FlightPhase phase;  ///< without a sub-phase: the whole scenario
    DesignFileName design;
};
using NamedPhases = base::FixedVector<NamedPhase, kMaxNamedPhases>;

/// `section` is [phases].
void read_named_phases(base::ConfigSection section, NamedPhases& phases);

}  // namespace tedavis::design
