#include "render_core/design/named_phases.hpp"

#include "render_core/design/config_values.hpp"

namespace tedavis::design {

void read_named_phases(base::ConfigSection section, NamedPhases& phases) {
    for (std::size_t n = 0; n < section.key_count(); ++n) {
        const std::string_view key = section.key_at(n);
        const flight::ParsedPhase phase = flight::phase_from_name(key);
        const std::string_view design = section.text(key);
        const NamedPhase named{phase.phase, DesignFileName(design)};
        if (!phase.ok)
            fault_of(section, key, "is no phase; write for instance takeoff, cruise or \"go_around.replanning\"");
        else if (named.design.empty() || named.design.cut())
            fault_of(section, key, "names a design by 1 to 127 letters");
        else if (!phases.try_push_back(named))
            fault_of(section, key, "is one phase too many; remove one");
    }
}

}  // namespace tedavis::design
