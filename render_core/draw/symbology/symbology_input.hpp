/// The input of a frame's symbology: values in SI units, decisions about what may be shown, and the view.
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/units.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/draw/symbology/adjacent_maps.hpp"
#include "render_core/draw/symbology/data_legend.hpp"
#include "render_core/draw/view_frame.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/legend_show.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/speed_bands.hpp"

namespace tedavis::draw {

/// The legend's input: the meaning of the picture's colours. Without `ground`, `tint` and `bands` there are no such colours.
struct LegendInput {
    bool ground = false;  ///< terrain: sea, missing data and what lies outside the database by their colours
    bool tint = false;    ///< the ground by `palette`; else it has the colour `plain`
    bool bands = false;   ///< warning colours over it
    design::Palette palette;
    double lowest = 0, highest = 0;  ///< values on the terrain, in the palette's unit; equal: the palette's own ends
    design::Color plain, sea, unknown;
    design::WarningBands warning_bands;
    double bands_lowered_m = 0;     ///< by the vertical uncertainty; 0: not at all
    bool accuracy_assumed = false;  ///< the uncertainty, or a part of it, is assumed by the design, not stated by data
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};

/// The picture below the symbols of positions and directions.
enum class SymbolGround : std::uint8_t {
    perspective,  ///< the world ahead: conformal symbols
    map,          ///< the world below: map symbols
    moving,       ///< in the transition between both, where neither kind of symbols is correct
};

/// A magnified area of the map.
struct MagnifiedSign {
    Point middle;                              ///< on the screen
    float radius_px = 0;                       ///< of the focus, as it is shown
    float reach_px = 0;                        ///< of the area in which places are displaced
    std::uint32_t power = 0, compression = 0;  ///< exponents of two: magnification of the focus, compression of the ring round it
};
inline constexpr std::size_t kMaxMagnifiedSigns = 4;

/// The map, or the orthographic view, whose middle is the own ship.
struct MapInput {
    double up_rad = 0;                         ///< true direction to which the map is oriented
    double px_per_m = 0;                       ///< on the ground; across the orthographic view
    bool is_oblique = false;                   ///< the orthographic view
    bool is_flat = false;                      ///< the ground is drawn without its relief
    double turn_rad = 0;                       ///< of the picture's top relative to `up_rad`, clockwise
    double look_down_rad = base::radians(90);  ///< of the view below the horizontal
    double above_ground_m = std::nan("");      ///< height of the own ship above the drawn ground; NaN: not known

    base::FixedVector<MagnifiedSign, kMaxMagnifiedSigns> magnified{};

    [[nodiscard]] double top_rad() const { return up_rad + turn_rad; }
};

/// Guidance. A value is valid only where the element's decision shows it; it is that of the decision's source.
/// Directions are relative to true north.
struct GuidanceInput {
    double slip_mps2 = 0;        ///< acceleration to the right
    double turn_rate_radps = 0;  ///< to the right
    double course_rad = 0, waypoint_bearing_rad = 0, selected_heading_rad = 0;
    double lateral_deviation = 0;   ///< rad (radio) or m (GNSS); positive: the own ship is right of the course
    double vertical_deviation = 0;  ///< rad (radio) or m (GNSS); positive: the own ship is above the path
    flight::NavigationSource navigation_source = flight::NavigationSource::none;
    double path_reference_rad = 0;                         ///< of the selected glide path, descending positive
    double director_pitch_rad = 0, director_roll_rad = 0;  ///< by which the attitude must change: nose up, right wing down
    double selected_altitude_m = 0, selected_airspeed_mps = 0, selected_vertical_speed_mps = 0;
    double airspeed_rate_mps2 = 0;
    double radio_minimum_m = 0;  ///< above ground
    double baro_minimum_m = 0;   ///< as the altimeter shows it
};

struct SymbologyInput {
    policy::DisplayDecisions decisions;
    design::SymbologySettings shown;
    design::SymbologyPalette palette = design::kDaySymbology;
    design::UnusualAttitudeLimits unusual;
    double excessive_bank_rad = base::radians(45);  ///< a larger bank is shown as excessive
    double standard_turn_radps = base::radians(3);  ///< rate of a standard-rate turn
    design::Color sky, ground;                      ///< of the permanent horizon
    flight::PhaseStatus phase;
    std::optional<base::Time> position_time;  ///< of the newest position; nothing: none yet, or a posed picture
    ViewFrame view;                           ///< as terrain and sky are drawn
    double view_heading_rad = 0;              ///< true
    double pitch_rad = 0, roll_rad = 0;
    double heading_rad = 0;  ///< as shown: true, magnetic or track, by decisions[heading].source
    double track_rad = 0;    ///< true; valid only with `shows_track`
    bool shows_track = false;
    /// To be added to a true direction for the reference of `heading_rad`; NaN where the variation is not known, or the heading
    /// not valid.
    double from_true_rad = 0;
    double airspeed_mps = 0;
    policy::SpeedBands bands;  ///< bands of the airspeed tape; none without an aircraft file
    double altitude_m = 0;     ///< above MSL (or pressure altitude), by decisions[altitude].source
    double vertical_speed_mps = 0;
    double baro_setting_pa = 0;
    double ground_height_m = 0;
    GuidanceInput guidance;
    double wind_speed_mps = 0, wind_from_rad = 0, outside_temperature_k = 0;
    base::Duration wind_age, temperature_age;  ///< of the older of the wind's two signals
    flight::LegendShow legend_show = flight::LegendShow::key;
    LegendInput legend;
    DataLegends data_legends;
    AdjacentInput adjacent;
    SymbolGround over = SymbolGround::perspective;
    MapInput map;
    double velocity_north_mps = 0, velocity_east_mps = 0, velocity_up_mps = 0;
};
static_assert(std::is_trivially_copyable_v<SymbologyInput>);

/// True heading of the view by the decision's source, 0 where there is none. Terrain, sky and symbols must share it.
[[nodiscard]] double view_heading_rad(const flight::AircraftState& state, const policy::DisplayDecisions& decisions) noexcept;

/// True direction at the top of the map by the decision's source, 0 (north) where there is none.
[[nodiscard]] double map_up_rad(const flight::AircraftState& state, const policy::DisplayDecisions& decisions) noexcept;

/// Makes the input. `gnss_msl_m`: the GNSS height above the ellipsoid minus the geoid undulation; used where the altitude's
/// decision requires it. `width` and `height` in pixels.
[[nodiscard]] SymbologyInput make_symbology_input(const flight::AircraftState& state, const policy::DisplayDecisions& decisions,
                                                  const flight::PhaseStatus& phase, const design::DesignSettings& design,
                                                  base::Time now, std::uint32_t width, std::uint32_t height,
                                                  double gnss_msl_m) noexcept;

}  // namespace tedavis::draw
