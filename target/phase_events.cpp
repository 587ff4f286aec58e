#include "target/phase_events.hpp"

#include <cinttypes>
#include <cstdio>

namespace tedavis::target {

void PhaseEvents::report(const flight::PhaseStatus& phase, std::uint64_t frame, base::Time presented) {
    const bool same = phase.presented == reported_.presented && phase.source == reported_.source &&
                      phase.switch_fault == reported_.switch_fault;
    if (same) return;
    reported_ = phase;
    const char* const sub_phase = flight::sub_phase_name(phase.presented);
    char line[160];
    std::snprintf(line, sizeof line, "phase %s%s%s of %s%s: frame %" PRIu64 " of %.6f s", flight::scenario_name(phase.presented),
                  *sub_phase != '\0' ? "." : "", sub_phase, flight::to_string(phase.source), phase.switch_fault ? "+fault" : "",
                  frame, (presented - base::Time{}).to_seconds());
    log_.write({line});
}

}  // namespace tedavis::target
