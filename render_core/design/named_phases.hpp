/// Which design is shown in which phase of flight: the table [phases] of a design.
///
///     [phases]
///     takeoff = "takeoff"                       # a scenario with all its phases: a short name, or a path from this file
///     "go_around.replanning" = "replanning"     # one phase; it has precedence over its scenario
///
/// Phases that are not named use the design itself. A design that is named in another one's table must not have such a table.
#pragma once

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxNamedPhases = 16;  ///< more than there are phases

using DesignFileName = base::FixedString<127>;

struct NamedPhase {
    flight::FlightPhase phase;  ///< without a sub-phase: the whole scenario
    DesignFileName design;
};
using NamedPhases = base::FixedVector<NamedPhase, kMaxNamedPhases>;

/// Reads the section [phases].
void read_named_phases(base::ConfigSection section, NamedPhases& phases);

}  // namespace tedavis::design
