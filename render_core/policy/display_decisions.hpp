/// What a frame may show: the decisions of the failure policy, which the planner and the drawers read.
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
    map_up,    ///< direction at the top of the map; `source` is true_track, else the heading of the view, else count_ for north
    wind,      ///< measured on board
    outside_temperature,
    slip,
    turn_rate,
    flaps,
    navigation_source,   ///< which receiver the course and its deviations come from
    course,              ///< of the navigation source
    lateral_deviation,   ///< from the course; `source` says of which receiver
    vertical_deviation,  ///< from the path; `source` says of which receiver
    waypoint_bearing,
    flight_path_reference,  ///< the glide path angle that is selected
    flight_director,        ///< in the state of the worse of its two signals
    selected_altitude,
    selected_heading,
    selected_airspeed,
    selected_vertical_speed,
    airspeed_trend,  ///< beside an airspeed that is not substituted; normal or absent
    radio_minimum,   ///< minimum of the approach above ground
    baro_minimum,    ///< minimum of the approach on the altimeter
    count_
};
inline constexpr std::size_t kElementCount = static_cast<std::size_t>(Element::count_);

enum class ElementShow : std::uint8_t {
    normal,
    substituted,  ///< the value comes from a source of second choice; an amber label names the source
    flagged,      ///< stale: the last value is shown with an amber flag
    failed,       ///< a red cross and a text replace the value
    absent,       ///< nothing is shown: the aircraft does not supply the value, or the value has no meaning now
};

/// Returns true where a value is drawn, be it stale or of second choice.
[[nodiscard]] constexpr bool shows_value(ElementShow show) { return show != ElementShow::failed && show != ElementShow::absent; }

/// Where the own ship is relative to a minimum of an approach.
enum class MinimumsState : std::uint8_t {
    none,   ///< no minimum is shown, or no approach is flown
    above,  ///< more than kNearMinimum_m above it
    near,   ///< at most so much above it
    at_or_below,
};
inline constexpr double kNearMinimum_m = 30.48;  ///< 100 ft

struct ElementDecision {
    ElementShow show = ElementShow::failed;
    flight::Signal source = flight::Signal::count_;  ///< signal whose value is shown; count_: no value is shown
};

enum class NoticeLevel : std::uint8_t { warning, caution, information };
struct Notice {
    NoticeLevel level = NoticeLevel::information;
    base::FixedString<31> text;  ///< upper case ASCII
};

struct DisplayDecisions {
    bool show_terrain = false;
    bool show_warning_colors = false;
    bool terrain_degraded = false;  ///< terrain is shown, but the position or the height is not reliable
    bool plain_horizon = false;     ///< a horizon of two plain colours replaces the terrain; never on the map
    bool below_terrain = false;     ///< the own ship flies below the database's surface: the plain horizon is grey over red, not
                                    ///< blue over brown
    TerrainAhead terrain_ahead = TerrainAhead::none;   ///< a notice shows it, and so do warning colours if they may be shown
    TerrainAhead obstacle_ahead = TerrainAhead::none;  ///< a notice shows it, and so do the obstacles that are in the way
    bool unusual_attitude = false;                     ///< the recovery picture is shown: chevrons, decluttered; flagged
    /// Signal that states the view's azimuth: true_heading, magnetic_heading (plus variation) or true_track. count_: no signal
    /// states it, the view faces north, and the 3D view shows no terrain.
    flight::Signal view_heading = flight::Signal::count_;
    /// Receiver that course and deviations come from; radio1 where the bus has never stated it.
    flight::NavigationSource navigation_source = flight::NavigationSource::none;
    bool is_on_ground = false;                          ///< by a valid height above ground, as exact as its source is
    MinimumsState radio_minimum = MinimumsState::none;  ///< by the radio height
    MinimumsState baro_minimum = MinimumsState::none;   ///< by the altimeter
    std::array<ElementDecision, kElementCount> elements{};
    base::FixedVector<Notice, 19> notices;               ///< most urgent first
    base::FixedVector<base::FixedString<47>, 72> flags;  ///< "signal.state" or a name

    [[nodiscard]] const ElementDecision& operator[](Element element) const { return elements[static_cast<std::size_t>(element)]; }
    [[nodiscard]] ElementDecision& operator[](Element element) { return elements[static_cast<std::size_t>(element)]; }
};
static_assert(std::is_trivially_copyable_v<DisplayDecisions>);

}  // namespace tedavis::policy
