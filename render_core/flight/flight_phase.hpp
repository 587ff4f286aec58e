/// Flight scenarios and their phases (thesis section 3.1): names, bus codes and the aspect that has priority.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::flight {

enum class Scenario : std::uint8_t { ground = 1, takeoff, cruise, approach, go_around, unknown };

/// A flight phase. Sub-phases count from 1 within their scenario; 0 means that none is stated.
struct FlightPhase {
    Scenario scenario = Scenario::unknown;
    std::uint8_t sub_phase = 0;

    /// Code of bus message 1830: 10 x number of the scenario + number of the sub-phase. Scenarios count from 1, so that a
    /// payload of zeros states no phase.
    [[nodiscard]] constexpr std::uint8_t code() const {
        return static_cast<std::uint8_t>(10 * static_cast<int>(scenario) + sub_phase);
    }
    friend constexpr bool operator==(FlightPhase a, FlightPhase b) { return a.code() == b.code(); }
    friend constexpr bool operator!=(FlightPhase a, FlightPhase b) { return !(a == b); }
};

inline constexpr FlightPhase kTakeoffStart{Scenario::takeoff, 1};
inline constexpr FlightPhase kTakeoffFirstClimb{Scenario::takeoff, 2};
inline constexpr FlightPhase kTakeoffSecondClimb{Scenario::takeoff, 3};
inline constexpr FlightPhase kApproachDescent{Scenario::approach, 1};
inline constexpr FlightPhase kApproachInitial{Scenario::approach, 2};
inline constexpr FlightPhase kApproachFinal{Scenario::approach, 3};
inline constexpr FlightPhase kApproachLanding{Scenario::approach, 4};
inline constexpr FlightPhase kGoAroundAbort{Scenario::go_around, 1};
inline constexpr FlightPhase kGoAroundReplanning{Scenario::go_around, 2};

/// Return "takeoff" and the like; "" for no sub-phase.
[[nodiscard]] const char* scenario_name(FlightPhase phase) noexcept;
[[nodiscard]] const char* sub_phase_name(FlightPhase phase) noexcept;

struct ParsedPhase {
    FlightPhase phase;
    bool ok = false;
};
/// Parses "takeoff" or "takeoff.first_climb".
[[nodiscard]] ParsedPhase phase_from_name(std::string_view name) noexcept;
/// Refuses codes outside the list (0, 7, 25, ...).
[[nodiscard]] ParsedPhase phase_from_code(std::uint8_t code) noexcept;

/// The source of a phase, in ascending order of authority.
enum class PhaseSource : std::uint8_t { none, held, motion, can, switches };
/// "none", "held", "motion", "can", "switch".
[[nodiscard]] const char* to_string(PhaseSource source) noexcept;

struct PhaseStatus {
    FlightPhase phase;
    PhaseSource source = PhaseSource::none;
    bool switch_fault = false;  ///< an impossible switch pattern was read; the last valid phase is kept
    bool disagreement = false;  ///< a source of lower authority states another scenario and is not merely late
    FlightPhase presented;      ///< the phase that the picture follows, without flicker (presented_phase.hpp)
    base::Time presented_since;
};
static_assert(std::is_trivially_copyable_v<PhaseStatus>);
/// Returns a status for a stated phase, without a history.
[[nodiscard]] constexpr PhaseStatus stated_phase(FlightPhase phase, PhaseSource source) {
    return {phase, source, false, false, phase, {}};
}

/// The aspect of the picture that a phase shows in detail (thesis Table 5.1).
enum class Aspect : std::uint8_t { terrain, data, uncertainty };
[[nodiscard]] Aspect prioritized_aspect(FlightPhase phase) noexcept;
[[nodiscard]] inline bool has_terrain_first(FlightPhase phase) noexcept { return prioritized_aspect(phase) == Aspect::terrain; }

}  // namespace tedavis::flight
