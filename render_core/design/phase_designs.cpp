#include "render_core/design/phase_designs.hpp"

namespace tedavis::design {

bool PhaseDesigns::add(const NamedPhase& named, const DesignSettings& design) {
    std::size_t place = place_of_name(named.design);
    if (place == 0) {
        if (!designs_.try_push_back(design) || !names_.try_push_back(named.design)) return false;
        place = designs_.size();
    }
    return choices_.try_push_back({named.phase, static_cast<std::uint8_t>(place)});
}

const DesignSettings* PhaseDesigns::find(const DesignFileName& name) const {
    const std::size_t place = place_of_name(name);
    return place == 0 ? nullptr : &at(place);
}

std::size_t PhaseDesigns::place_of_name(const DesignFileName& name) const {
    for (std::size_t n = 0; n < names_.size(); ++n)
        if (names_[n].view() == name.view()) return n + 1;
    return 0;
}

std::size_t PhaseDesigns::place_of(flight::FlightPhase phase) const noexcept {
    std::size_t of_scenario = 0;
    for (const Choice& choice : choices_) {
        if (choice.phase == phase) return choice.place;
        if (choice.phase == flight::FlightPhase{phase.scenario, 0}) of_scenario = choice.place;
    }
    return of_scenario;
}

}  // namespace tedavis::design
