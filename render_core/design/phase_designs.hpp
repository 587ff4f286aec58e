/// The designs of a display by the phase of flight, read from their files (named_phases.hpp). Plain data.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/design/named_phases.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxPhaseDesigns = 6;  ///< different ones beside the design itself

class PhaseDesigns {
public:
    /// False where there is no room for another design. `name`: as the table says; one name is one design.
    [[nodiscard]] bool add(const NamedPhase& named, const DesignSettings& design);
    /// The design of that name, where one was added already; null: none.
    [[nodiscard]] const DesignSettings* find(const DesignFileName& name) const;

    /// Place of the phase's design; 0: none is named for it.
    [[nodiscard]] std::size_t place_of(flight::FlightPhase phase) const noexcept;
    /// How many there are; places are 1 to that.
    [[nodiscard]] std::size_t size() const { return designs_.size(); }
    [[nodiscard]] bool empty() const { return designs_.empty(); }
    [[nodiscard]] const DesignSettings& at(std::size_t place) const { return designs_[place - 1]; }
    [[nodiscard]] DesignSettings& at(std::size_t place) { return designs_[place - 1]; }

private:
    struct Choice {
        flight::FlightPhase phase;
        std::uint8_t place = 0;
    };
    [[nodiscard]] std::size_t place_of_name(const DesignFileName& name) const;

    base::FixedVector<DesignSettings, kMaxPhaseDesigns> designs_;
    base::FixedVector<DesignFileName, kMaxPhaseDesigns> names_;
    base::FixedVector<Choice, kMaxNamedPhases> choices_;
};
static_assert(std::is_trivially_copyable_v<PhaseDesigns>);

}  // namespace tedavis::design
