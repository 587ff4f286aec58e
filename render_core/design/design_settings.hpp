/// A design: everything about a picture that a designer chooses, read from one file of configs/designs/.
///
/// A file may be based on another (inherit_bases.hpp): what it does not say, that one says. Plain data in SI and radians; the
/// file speaks in degrees, feet and hexadecimal sRGB colours. Every key is optional except `name`: what is absent has the value
/// that stands here.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
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

/// What the terrain is seen as: from the own ship, from far above as a map, or obliquely from far away, where equal lengths are
/// equally long on the screen.
enum class ViewMode : std::uint8_t { perspective, map, orthographic };
inline constexpr std::array<std::string_view, 3> kViewModeNames{"3d", "map", "orthographic"};

/// What data stand on: the terrain, or a plane in its colours.
enum class Reference : std::uint8_t { terrain, flat };
inline constexpr std::array<std::string_view, 2> kReferenceNames{"terrain", "flat"};

/// What stands at the top of the map; track_up falls back to the heading, then to north.
enum class MapOrientation : std::uint8_t { north_up, track_up };
inline constexpr std::array<std::string_view, 2> kMapOrientationNames{"north_up", "track_up"};

struct ViewSettings {
    ViewMode mode = ViewMode::perspective;
    MapOrientation map_orientation = MapOrientation::north_up;
    /// (500 .. 500,000; orthographic ..kMaxOrthographicRange_m) from the own ship to the nearest edge.
    double map_range_m = 20'000;
    double look_down_rad = base::radians(35);                   ///< (25 .. 90 degrees) of the orthographic view, from level
    double look_turn_rad = 0;                                   ///< (-180 .. 180 degrees) of it, clockwise from what is up
    Reference reference = Reference::terrain;                   ///< flat: not in perspective
    double flat_msl_m = 0;                                      ///< (-500 .. 9000) of the plane
    double transition_s = 1;                                    ///< (0.5 .. 2) in which the eye travels to another mode
    double horizontal_field_of_view_rad = base::radians(60);    ///< (10 .. 120 degrees), over the whole width
    double eye_forward_m = 0, eye_right_m = 0, eye_down_m = 0;  ///< eye in body axes from the reference point of the own ship
    double dpi = 96;  ///< pixels an inch of the panel; text never gets smaller than legible on it
};

/// The eye is no farther than floats allow; beyond this range lengths would differ by more than a hundredth (display/eye.hpp).
inline constexpr double kMaxOrthographicRange_m = 15'000;

/// What draws the terrain.
enum class TerrainRenderer : std::uint8_t {
    raster,  ///< triangles, as many as tau_px asks for
    trace,   ///< rays through every pixel, over all that the database has; where that cannot be, raster
};
inline constexpr std::array<std::string_view, 2> kTerrainRendererNames{"raster", "trace"};

struct TerrainSettings {
    TerrainRenderer renderer = TerrainRenderer::raster;
    double tau_px = 1.0;  ///< pixel error asked for, (0.1 .. 32)
    Palette palette;      ///< colours of the style's texture
    Color sea{0x30, 0x58, 0x80};
    Color unknown{0xC0, 0x30, 0xC0};  ///< posts without data (magenta in plan views of terrain systems)
    TerrainStyle style;
    bool conservative_up = false;  ///< the silhouette is never below the true terrain
};

/// Air as it is (effects, aerial_perspective) in the place of the haze's one colour.
struct AirSettings {
    bool is_shown = false;
    double visibility_m = 40'000;      ///< over which contrast falls to 2 % at sea level
    double horizon_brightness = 0.75;  ///< of the sky at the horizon, square to the sun; of full scale
};

struct SkySettings {
    Color zenith{0x1C, 0x54, 0xA8};
    Color horizon{0x9C, 0xC4, 0xE8};
    Color ground{0x6E, 0x4A, 0x26};  ///< below the horizon where no terrain is drawn
    Color ground_horizon{0x96, 0x74, 0x4C};
    Color haze{0xB4, 0xC8, 0xDC};
    double haze_distance_m = 60'000;  ///< at which the haze hides 1 - 1/e of the terrain; 0 for none
    AirSettings air;
};

/// Beyond these figures of merit terrain is shown as degraded.
struct DegradationLimits {
    double horizontal_accuracy_m = 50;
    double vertical_accuracy_m = 30;
    double terrain_error_px = 4;  ///< terrain that the device's budgets force to be coarser is said to be coarse
    /// Terrain whose error, as far as haze lets it be seen, is larger is not shown while finer chunks are being read.
    double terrain_removed_px = 500;
    bool show_reduced = false;  ///< a notice says where the picture is reduced for the frame's deadline
};

/// Beyond these angles the picture changes to recovery: chevrons, no flight path, no warning colours.
struct UnusualAttitudeLimits {
    double pitch_up_rad = base::radians(30);
    double pitch_down_rad = base::radians(20);
    double roll_rad = base::radians(60);
};

enum class HeightUnit : std::uint8_t { feet, metres };

/// What the design shows; the failure policy decides whether it can be shown.
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
    bool legend = true;                         ///< what the colours of the terrain mean
    HeightUnit legend_unit = HeightUnit::feet;  ///< of the heights in the legend
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

/// Some element of the data has the surface grid's lines.
[[nodiscard]] bool has_grid_on_data(const DesignSettings& design) noexcept;

/// Some focus is to be shown larger than what is round it: on a map or obliquely from far away, never as the own ship sees it.
[[nodiscard]] bool magnifies(const DesignSettings& design) noexcept;

/// Reads a design file and, through `files`, the palettes that it names and the designs that it is based on; start-up only
/// (allocates while it reads). The error is one sentence "file:line: what, what to do", of the file that is wrong. `phases`,
/// where given, gets the designs that the file names for phases.
[[nodiscard]] base::Result<DesignSettings, base::Error> read_design_settings(std::string_view text, std::string_view file_name,
                                                                             DesignSource& files, NamedPhases* phases = nullptr);
/// The same from a reader of the file that nobody read; it has what the file inherits afterwards.
[[nodiscard]] base::Result<DesignSettings, base::Error> read_design_settings(base::ConfigReader& reader, DesignSource& files,
                                                                             NamedPhases* phases = nullptr);

/// The values of an empty file: the picture of a display that was given no design.
[[nodiscard]] DesignSettings default_design_settings() noexcept;
/// Turns the warning colours on; with the EGPWS bands where the design's own would leave ground ahead as it is.
void require_warning_colors(DesignSettings& design) noexcept;

}  // namespace tedavis::design
