/// A palette: colours for values of the terrain or of spatial data. Each is a file of configs/palettes/.
///
///     name = "alpine"
///     title = "GROUND ELEV"      over the legend, upper case, at most 11 characters
///     kind = "hypsometric"       heights; "sequential": from little to much; "diverging": both ways from a middle; "nominal":
///                                classes that have names and no order
///     unit = "m"                 of the values: "m", "deg", "m/s", "dBZ", "K" or "1"
///     purpose = "terrain"        what it colours: "terrain" (default), "data" on the ground, or "objects" in the air
///     order = "lightness"        what tells more from less: "lightness" or "hue"
///     fits_terrain = false       hypsometric only: the stops are spread over the heights of the terrain that is shown
///     [[stop]]                   2 to 16, values ascending
///     value = 0
///     color = "#32443a"
///     [[class]]                  instead of stops, 2 to 16 for a nominal palette, which needs no unit and no order
///     name = "forest"            an attribute's class of this name has this colour
///     color = "#4f6b43"
///
/// The core opens no files: the reader of a design passes a PaletteSource that finds the palettes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::design {

enum class PaletteKind : std::uint8_t { hypsometric, sequential, diverging, nominal };
enum class PaletteUnit : std::uint8_t { metres, degrees, one, metres_per_second, reflectivity, kelvin };
/// Returns the unit as files write it.
[[nodiscard]] std::string_view unit_name(PaletteUnit unit) noexcept;
enum class PalettePurpose : std::uint8_t { terrain, data, objects };
enum class PaletteOrder : std::uint8_t { lightness, hue };

struct ColorStop {
    double value = 0;  ///< metres (hypsometric: above mean sea level), radians or a plain number, by the palette's unit
    Color color;
};
inline constexpr std::size_t kMaxColorStops = 16;
using ClassName = base::FixedString<23>;  ///< as long as those of a scene's attributes

struct Palette {
    base::FixedString<47> name;
    base::FixedString<11> title;
    PaletteKind kind = PaletteKind::hypsometric;
    PaletteUnit unit = PaletteUnit::metres;
    PaletteOrder order = PaletteOrder::lightness;
    PalettePurpose purpose = PalettePurpose::terrain;
    bool fits_terrain = false;                           ///< fitted_palette() spreads the stops over the heights of the terrain
    base::FixedVector<ColorStop, kMaxColorStops> stops;  ///< ascending values, at least two
    base::FixedVector<ClassName, kMaxColorStops> class_names;  ///< names of a nominal palette's classes; stop n has the value n

    [[nodiscard]] bool is_nominal() const { return kind == PaletteKind::nominal; }
};
static_assert(std::is_trivially_copyable_v<Palette>);

/// Returns the colour of a value: linear between the stops (in encoded values), constant beyond them; for a nominal palette
/// that of the nearest stop.
[[nodiscard]] Color color_of_value(const Palette& palette, double value) noexcept;

/// Returns the colour of a class; transparent where a nominal palette has no class of this name.
[[nodiscard]] Color color_of_name(const Palette& palette, std::string_view name) noexcept;

/// Returns the height palette of a display without a design; it equals configs/palettes/alpine.toml.
[[nodiscard]] Palette alpine_palette() noexcept;

/// Below this difference of heights the terrain is flat land, which must not look like mountains.
inline constexpr double kMinFittedSpan_m = 300;

/// Returns the palette for terrain between two heights (m above MSL). One that fits terrain has its first stop at the lowest
/// height and its last one at the highest, at least kMinFittedSpan_m above, the others between them as in the file; any other
/// palette is returned unchanged.
[[nodiscard]] Palette fitted_palette(const Palette& palette, double lowest_m, double highest_m) noexcept;

/// Reads a palette file; start-up only (allocates while it reads). The error is one sentence "file:line: what, what to do".
[[nodiscard]] base::Result<Palette, base::Error> read_palette(std::string_view text, std::string_view file_name);

/// Port: finds the palettes that a design names.
class PaletteSource {
public:
    virtual ~PaletteSource() = default;
    /// Finds a palette by its short name or path. The error is one sentence.
    [[nodiscard]] virtual base::Result<Palette, base::Error> find(const base::StatedFile& palette) = 0;
};

/// True for the short name of a shipped file; a path contains a dot or a slash.
[[nodiscard]] bool is_short_name(std::string_view name) noexcept;

}  // namespace tedavis::design
