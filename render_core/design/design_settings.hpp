/// A design: all choices about a picture, read from one file of configs/designs/.
///
/// A file may be based on another (inherit_bases.hpp) and inherits the keys that it does not have. Plain data in SI units and
/// radians; files use degrees, feet and hexadecimal sRGB colours. Every key except `name` is optional; its default is the value
/// in this header.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/display_units.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/units.hpp"
#include "render_core/design/band_widening.hpp"
#include "render_core/design/color.hpp"
#include "render_core/design/data_style.hpp"
#include "render_core/design/design_source.hpp"
#include "render_core/design/focus_settings.hpp"
#include "render_core/design/label_settings.hpp"
#include "render_core/design/named_phases.hpp"
#include "render_core/design/palette.hpp"
#include "render_core/design/priority.hpp"
#include "render_core/design/terrain_style.hpp"
#include "render_core/design/view_effects.hpp"
#include "render_core/design/warning_bands.hpp"

namespace tedavis::design {

/// The view of the terrain: from the own ship, from far above as a map, or obliquely from far away, where equal lengths have
/// equal lengths on the screen.
enum class ViewMode : std::uint8_t { perspective, map, orthographic };
inline constexpr std::array<std::string_view, 3> kViewModeNames{"3d", "map", "orthographic"};

/// The surface that data stand on: the terrain, or a plane in its colours.
enum class Reference : std::uint8_t { terrain, flat };
inline constexpr std::array<std::string_view, 2> kReferenceNames{"terrain", "flat"};

/// The direction at the top of the map; track_up falls back to the heading, then to north.
enum class MapOrientation : std::uint8_t { north_up, track_up };
inline constexpr std::array<std::string_view, 2> kMapOrientationNames{"north_up", "track_up"};

struct ViewSettings {
    ViewMode mode = ViewMode::perspective;
    MapOrientation map_orientation = MapOrientation::north_up;
    /// (500 .. 500,000; orthographic up to kMaxOrthographicRange_m) from the own ship to the nearest edge of the picture.
    double map_range_m = 20'000;
    double look_down_rad = base::radians(35);                   ///< (25 .. 90 degrees) look-down angle of the orthographic view
    double look_turn_rad = 0;                                   ///< (-180 .. 180 degrees) its azimuth, clockwise from "up"
    Reference reference = Reference::terrain;                   ///< flat: not in perspective
    double flat_msl_m = 0;                                      ///< (-500 .. 9000) height of the plane
    double transition_s = 1;                                    ///< (0.5 .. 2) duration of the camera's motion to another mode
    double horizontal_field_of_view_rad = base::radians(60);    ///< (10 .. 120 degrees), over the whole width
    double eye_forward_m = 0, eye_right_m = 0, eye_down_m = 0;  ///< eye point in body axes, from the aircraft's (EyePoint)
    double dpi = 96;  ///< pixels per inch of the panel; it sets the least legible text size
};

/// Floats limit the distance of the eye point; beyond this range lengths would differ by more than 1 %
/// (display/planner/camera.hpp).
inline constexpr double kMaxOrthographicRange_m = 15'000;

/// How the terrain is drawn.
enum class TerrainRenderer : std::uint8_t {
    raster,     ///< triangles, as many as tau_px requires
    trace,      ///< ray tracing of every pixel at the database's full resolution; raster where that is not possible
    automatic,  ///< whichever costs less on the device (effects/renderer_choice.hpp)
};
inline constexpr std::array<std::string_view, 3> kTerrainRendererNames{"raster", "trace", "auto"};

struct TerrainSettings {
    TerrainRenderer renderer = TerrainRenderer::raster;
    double tau_px = 1.0;  ///< requested pixel error tau, (0.1 .. 32)
    Palette palette;      ///< palette of the style's texture
    Color sea{0x30, 0x58, 0x80};
    Color unknown{0x4A, 0x32, 0x26};  ///< ground without data and beyond the database, which is hatched
    TerrainStyle style;
    bool conservative_up = false;  ///< the silhouette is never below the true terrain
};
/// Whether rays may draw the terrain of a design: everything that they need must be there at the start.
[[nodiscard]] inline bool may_trace(const TerrainSettings& terrain) noexcept {
    return terrain.renderer != TerrainRenderer::raster;
}

/// Atmospheric scattering (effect aerial_perspective), which replaces the haze of one colour.
struct AirSettings {
    bool is_shown = false;
    double visibility_m = 40'000;      ///< distance over which contrast falls to 2 % at sea level
    double horizon_brightness = 0.75;  ///< share of full scale of the sky at the horizon, 90 degrees from the sun
};

struct SkySettings {
    Color zenith{0x1C, 0x54, 0xA8};
    Color horizon{0x9C, 0xC4, 0xE8};
    Color ground{0x6E, 0x4A, 0x26};  ///< below the horizon where no terrain is drawn
    Color ground_horizon{0x96, 0x74, 0x4C};
    Color haze{0xB4, 0xC8, 0xDC};
    double haze_distance_m = 60'000;  ///< distance at which haze hides 1 - 1/e of the terrain; 0: no haze
    AirSettings air;
};

/// Limits of accuracy beyond which terrain is shown as degraded.
struct DegradationLimits {
    double horizontal_accuracy_m = 50;
    double vertical_accuracy_m = 30;
    double terrain_error_px = 4;  ///< error beyond which terrain limited by the device's budgets is reported as coarse
    /// Terrain with a larger error, reduced by haze, is not shown while finer chunks are being read.
    double terrain_removed_px = 500;
    bool show_reduced = false;  ///< show a notice where the picture is reduced for the frame's deadline
};

/// Attitude limits beyond which the recovery picture is shown: chevrons, no flight path, no warning colours.
struct UnusualAttitudeLimits {
    double pitch_up_rad = base::radians(30);
    double pitch_down_rad = base::radians(20);
    double roll_rad = base::radians(60);
};

/// Symbols that the design shows; the failure policy decides whether they may be shown.
struct SymbologySettings {
    bool attitude = true;
    bool map = true;  ///< own ship, range ring and north arrow
    bool heading = true;
    bool airspeed = true;
    bool altitude = true;
    bool vertical_speed = true;
    bool flight_path = true;
    bool baro_setting = true;
    bool ground_height = true;
    bool air = true;  ///< wind and temperature measured on board
    bool phase = true;
    bool legend = true;                                             ///< legend of the terrain's colours
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;  ///< of all that is written
};

struct DesignSettings {
    base::FixedString<47> name;
    ViewSettings view;
    TerrainSettings terrain;
    DataStyle data;
    LabelSettings labels;
    PrioritySettings priority;
    FocusList foci;
    SkySettings sky;
    ViewEffects effects;
    bool warning_colors = true;
    WarningBands warning_bands;
    WideningSettings widening;
    DegradationLimits degradation;
    UnusualAttitudeLimits unusual_attitude;
    SymbologySettings symbology;
};
static_assert(std::is_trivially_copyable_v<DesignSettings>);

/// True where an element of the data has the surface grid's lines.
[[nodiscard]] bool has_grid_on_data(const DesignSettings& design) noexcept;

/// True where a focus is to be magnified: on the map and in the orthographic view, never in the own ship's view.
[[nodiscard]] bool magnifies(const DesignSettings& design) noexcept;

/// Reads a design file and, through `files`, the palettes that it names and the designs that it is based on; start-up only
/// (allocates while it reads). The error is one sentence "file:line: what, what to do", of the file that is wrong. `phases`,
/// where given, receives the designs that the file names for phases.
[[nodiscard]] base::Result<DesignSettings, base::Error> read_design_settings(std::string_view text, std::string_view file_name,
                                                                             DesignSource& files, NamedPhases* phases = nullptr);
/// The same from an unused reader of the file; afterwards the reader contains the inherited keys.
[[nodiscard]] base::Result<DesignSettings, base::Error> read_design_settings(base::ConfigReader& reader, DesignSource& files,
                                                                             NamedPhases* phases = nullptr);

/// Returns the values of an empty file, which a display without a design uses.
[[nodiscard]] DesignSettings default_design_settings() noexcept;

}  // namespace tedavis::design
