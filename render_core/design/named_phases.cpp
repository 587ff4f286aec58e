#include "render_core/design/named_phases.hpp"

namespace tedavis::design {

void read_named_phases(base::ConfigSection section, NamedPhases& phases) {
    for (std::size_t n = 0; n < section.key_count(); ++n) {
        const std::string_view key = section.key_at(n);
        const flight::ParsedPhase phase = flight::phase_from_name(key);
        const std::string_view design = section.text(key);
        const NamedPhase named{phase.phase, DesignFileName(design)};
        if (!phase.ok)
            section.fault(key, "no phase has this name; write for instance takeoff, cruise or \"go_around.replanning\"");
        else if (named.design.empty() || named.design.cut())
            section.fault(key, "a design's name or path has 1 to 127 letters");
        else if (!phases.try_push_back(named))
            section.fault(key, "there are more phases than kMaxNamedPhases; remove one");
    }
}

}  // namespace tedavis::design
