/// Focus and context (thesis, 5.2): what is emphasised, and how the rest is reduced. Each table [[focus]] of a design file
/// defines a focus; where several apply, the greatest degree counts.
///
///     [[focus]]
///     name = "destination"         as the record and the cue for a hidden focus call it
///     shape = "circle"             "point", "path", "circle", "square", "sphere", "cuboid", or "data"
///     at = "destination"           "own_ship", "destination", "flight_path", "place", "position", "hazard"
///     place = "RWY 24"             a feature of the scene: of `place`; of `destination` the runway, where it is not the nearest
///     position_deg = [46.8, 9.8]   latitude and longitude, of `position`
///     ahead_s = 300                so much of the flight to come, of `flight_path`
///     radius_m = 3000              of circles and spheres, half the side of squares and cuboids, proximity of the others
///     height_m = 2500              above MSL, of a sphere's middle; absent: that of the thing itself
///     lower_m = 1000               above MSL, of a cuboid
///     upper_m = 3000               the same
///
///     layer = "wind"               of a data focus, or role = "wind": where the values are, and then
///     attribute = "speed"
///     value = 12                   one of `value`, `interval`, `extreme`
///     interval = [10, 15]
///     extreme = "highest"          "lowest": of all that are valid now
///     within = 0.5                 so far from `value` or the extreme is in focus, too
///     similar = 3                  so far beyond that is intermediate context
///
///     [focus.context]              how far the intermediate context reaches round a focus of space
///     [focus.terrain]              what the ground of the context looks like, and
///     [focus.data]                 what its data look like: the context is common to all foci, so one of them states each
///     [focus.border]               how the focus' rim is shown
///     [focus.distortion]           more room for the focus on the screen
///
/// Plain data; metres, radians, attributes in their own units. Reading: start-up only, faults go to the section.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/design/color.hpp"
#include "render_core/scene/focus_region.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

enum class FocusShape : std::uint8_t { point, path, circle, square, sphere, cuboid, data };
inline constexpr std::array<std::string_view, 7> kFocusShapeNames{"point",  "path",   "circle", "square",
                                                                  "sphere", "cuboid", "data"};

/// Where a focus is. `hazard`: where the predicted track reaches the first hazard (PrioritySettings); the focus is empty while
/// there is none.
enum class FocusAt : std::uint8_t { own_ship, destination, flight_path, place, position, hazard };
inline constexpr std::array<std::string_view, 6> kFocusAtNames{"own_ship", "destination", "flight_path",
                                                               "place",    "position",    "hazard"};

/// The values of a data focus: an interval, or those close to an extreme.
enum class FocusValues : std::uint8_t { interval, highest, lowest };

struct FocusOfData {
    base::FixedString<31> layer;  ///< empty: all layers of the role
    scene::LayerRole role = scene::LayerRole::count;
    base::FixedString<31> attribute;
    FocusValues values = FocusValues::interval;
    double low = 0, high = 0;  ///< limits of an interval; `value` is stored as an interval too
    double within = 0;         ///< distance from the extreme
    double similar = 0;        ///< width of the intermediate context beyond the focus
};

/// The look of the ground in the context; in the intermediate context it is interpolated.
struct FocusTerrain {
    bool sketch_outside = false;            ///< lines instead of shading
    double brightness = 1, saturation = 1;  ///< 0..1
    double blur_px = 0;                     ///< 0..kMaxBlur_px, increasing with the distance from the focus

    [[nodiscard]] bool is_any() const { return sketch_outside || brightness < 1 || saturation < 1 || blur_px > 0; }
};

/// How data in the context are shown.
enum class FocusContextData : std::uint8_t { hidden, as_intermediate, shown };
inline constexpr std::array<std::string_view, 3> kFocusContextDataNames{"hidden", "as_intermediate", "shown"};

/// The look of data in the intermediate context at its outer edge; towards the focus it is interpolated.
struct FocusData {
    double detail = 1, brightness = 1, saturation = 1, size = 1;  ///< 0..1
    std::uint32_t aggregate = 1;                                  ///< one glyph for aggregate x aggregate glyphs
    FocusContextData context = FocusContextData::shown;

    [[nodiscard]] bool is_any() const {
        return detail < 1 || brightness < 1 || saturation < 1 || size < 1 || aggregate > 1 || context != FocusContextData::shown;
    }
};

enum class FocusBorderKind : std::uint8_t { none, line, halo, grid };
inline constexpr std::array<std::string_view, 4> kFocusBorderNames{"none", "line", "halo", "grid"};

struct FocusBorder {
    FocusBorderKind kind = FocusBorderKind::none;
    Color color{0xFF, 0xFF, 0xFF};
    double width_px = 2;
};

inline constexpr std::uint32_t kMaxFocusPower = 4;

struct FocusSettings {
    base::FixedString<23> name;
    FocusShape shape = FocusShape::circle;
    FocusAt at = FocusAt::own_ship;
    base::FixedString<23> place;  ///< empty: not stated
    double latitude_rad = 0, longitude_rad = 0;
    double ahead_s = 300;
    double radius_m = 2000;
    double height_m = 0;
    bool has_height = false;
    double lower_m = 0, upper_m = 0;
    FocusOfData data;
    scene::FocusContext context;
    FocusTerrain terrain;
    FocusData of_data;
    FocusBorder border;
    std::uint32_t power = 0;  ///< the focus is magnified by 2^power; 0..kMaxFocusPower
};
static_assert(std::is_trivially_copyable_v<FocusSettings>);

using FocusList = base::FixedVector<FocusSettings, scene::kMaxFoci>;

/// Returns the look of the context, which is common to all foci: that of the first focus that states one.
[[nodiscard]] const FocusTerrain& terrain_of_context(const FocusList& foci) noexcept;
[[nodiscard]] const FocusData& data_of_context(const FocusList& foci) noexcept;
/// True where a focus changes the look of the ground.
[[nodiscard]] bool change_the_ground(const FocusList& foci) noexcept;

/// Brightness factor of the context where blur is not possible or given up.
inline constexpr double kBlurAsBrightness = 0.7;
[[nodiscard]] FocusTerrain darkened_instead_of_blurred(FocusTerrain look) noexcept;

/// Reads the tables [[focus]]; `root` is the root table of the design file.
void read_foci(base::ConfigSection& root, FocusList& foci);

/// Parses one focus from a command line: the keys of [[focus]] within one line of TOML, `shape = "point", at = "place", place =
/// "DAVOS", terrain.brightness = 0.5`. The error is one sentence.
[[nodiscard]] base::Result<FocusSettings, base::Error> read_focus(std::string_view line);

}  // namespace tedavis::design
