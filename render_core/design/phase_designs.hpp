/// The designs of a display for phases of flight (named_phases.hpp). Plain data.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/design/named_phases.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxPhaseDesigns = 6;  ///< different designs, without the design itself

class PhaseDesigns {
public:
    /// Adds a phase's design. Returns false where there is no room for another design. Equal names in the table mean the same
    /// design.
    [[nodiscard]] bool add(const NamedPhase& named, const DesignSettings& design);
    /// Returns the design of a name that was added before, or null.
    [[nodiscard]] const DesignSettings* find(const DesignFileName& name) const;

    /// Returns the index of the phase's design, from 1; 0 where none is named for it.
    [[nodiscard]] std::size_t place_of(flight::FlightPhase phase) const noexcept;
    /// Number of designs; indices are 1 to size().
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
