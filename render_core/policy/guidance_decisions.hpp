/// Decides what is shown of guidance: course and deviations of the navigation source, flight director, glide path, selected
/// values, minimums. Pure functions; failure_policy.hpp calls them. The rows are those of render_core/display/README.md.
#pragma once

#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/group_decisions.hpp"

namespace tedavis::policy {

/// False for groups of a receiver that is not the navigation source: it may be silent.
[[nodiscard]] bool counts_for_guidance(const GroupDecisions& groups, SignalGroup group) noexcept;

/// Fills in the elements of guidance other than the minimums, and the navigation source.
void decide_guidance(const GroupDecisions& groups, flight::Scenario scenario, DisplayDecisions& decisions) noexcept;

/// Fills in the minimums. Needs the decision about the height above ground. Returns true where the minimum on the altimeter lies
/// in the ground below the own ship, and is removed.
[[nodiscard]] bool decide_minimums(const GroupDecisions& groups, flight::Scenario scenario, DisplayDecisions& decisions) noexcept;

}  // namespace tedavis::policy
