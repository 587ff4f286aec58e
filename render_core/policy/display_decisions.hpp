/// What a frame may show: the decisions of the failure policy, read by planner and drawers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/flight/signal.hpp"
#include "render_core/policy/terrain_ahead.hpp"

namespace tedavis::policy {

/// The elements of information on the display.
enum class Element : std::uint8_t {
    attitude,
    heading,
    airspeed,
    altitude,
    vertical_speed,
    baro_setting,
    ground_height,
    flight_path,
    position,  ///< position of the own ship on the map
    map_up,    ///< what is up on the map; `source` is true_track, the view's heading instead, or count_ for north
    wind,      ///< measured on board
    outside_temperature,
    count_
};
inline constexpr std::size_t kElementCount = static_cast<std::size_t>(Element::count_);

enum class ElementShow : std::uint8_t {
    normal,
    substituted,  ///< shown from another source than the first choice; an amber label names it
    flagged,      ///< stale: the last value is shown with an amber flag
    failed,       ///< red cross and text instead of the value
    absent,       ///< nothing is shown: the aircraft does not supply it, or it has no meaning now
};

struct ElementDecision {
    ElementShow show = ElementShow::failed;
    flight::Signal source = flight::Signal::count_;  ///< signal whose value is shown; count_ for none
};

enum class NoticeLevel : std::uint8_t { warning, caution, information };
struct Notice {
    NoticeLevel level = NoticeLevel::information;
    base::FixedString<31> text;  ///< upper case ASCII
};

inline constexpr std::string_view kUnusualAttitudeFlag = "attitude.unusual";  ///< flag of the recovery picture

struct DisplayDecisions {
    bool show_terrain = false;
    bool show_warning_colors = false;
    bool terrain_degraded = false;  ///< terrain is shown, but position or height are not reliable
    bool plain_horizon = false;     ///< blue over brown by attitude, without terrain; never on the map
    bool below_terrain = false;     ///< the own ship flies below the database's surface: the plain horizon is grey over red
    TerrainAhead terrain_ahead = TerrainAhead::none;  ///< shown by a notice, and by the warning colours where they may be shown
    bool unusual_attitude = false;                    ///< recovery picture: chevrons, decluttered; flagged
    /// Signal that gives the view's azimuth: true_heading, magnetic_heading (plus variation), true_track, or count_ (none: the
    /// view faces north and no terrain is drawn).
    flight::Signal view_heading = flight::Signal::count_;
    std::array<ElementDecision, kElementCount> elements{};
    base::FixedVector<Notice, 16> notices;               ///< most urgent first
    base::FixedVector<base::FixedString<47>, 32> flags;  ///< "signal.state" or a name

    [[nodiscard]] const ElementDecision& operator[](Element element) const { return elements[static_cast<std::size_t>(element)]; }
    [[nodiscard]] ElementDecision& operator[](Element element) { return elements[static_cast<std::size_t>(element)]; }
};
static_assert(std::is_trivially_copyable_v<DisplayDecisions>);

}  // namespace tedavis::policy
