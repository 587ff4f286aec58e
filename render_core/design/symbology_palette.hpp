/// The palette of the symbology (configs/palettes/symbology/*.toml): one color for each role that a symbol has, by day and by
/// night, and the sizes of type. Nothing of the symbology has another color, but for the samples of legends, which have those of
/// the data.
///
/// Roles follow AC 25-11B, table 5-1: red warns, amber cautions, white is for scales and values, cyan for what the pilot has
/// selected, magenta for the course of GNSS, green for what is engaged and for radio receivers. Night changes the symbology
/// alone: terrain, sky and data keep their colors (`[panel]` of a design dims the whole picture).
///
/// Plain data, sRGB-encoded. Memory  reading allocates (start-up only). Failure  one sentence with file and line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::design {

enum class SymbolRole : std::uint8_t {
    scale,  ///< scales, values, and what has no other role
    warning,
    caution,
    engaged,      ///< what is engaged, and course and deviations of radio receivers
    selected,     ///< what the pilot has selected
    gnss_course,  ///< course and deviations of GNSS
    reference,    ///< the aircraft's own symbols
    rim,          ///< around signs that stand on the ground
    tape_ground,
    readout_ground,
    strip_ground,  ///< of the strip of annunciations
    count_
};
inline constexpr std::size_t kSymbolRoleCount = static_cast<std::size_t>(SymbolRole::count_);
/// Roles of signs come first; the rest are their rims and grounds.
inline constexpr std::size_t kSignRoleCount = static_cast<std::size_t>(SymbolRole::rim);
inline constexpr std::array<std::string_view, kSymbolRoleCount> kSymbolRoleNames = {
    "scale",     "warning", "caution",     "engaged",        "selected",    "gnss_course",
    "reference", "rim",     "tape_ground", "readout_ground", "strip_ground"};

enum class SymbologyLight : std::uint8_t { day, night };
inline constexpr std::array<std::string_view, 2> kSymbologyLightNames = {"day", "night"};

/// Sizes in texts, the display's unit of size.
struct SymbologyType {
    float value_large = 1.25f;  ///< (0.5 .. 2) airspeed and altitude
    float value = 1.15f;        ///< (0.5 .. 2) other numbers in frames
    float label = 0.8f;         ///< (0.5 .. 2) names beside values
};

/// The colors of one light, by roles.
struct SymbologyPalette {
    std::array<Color, kSymbolRoleCount> colors{};
    SymbologyType type;

    [[nodiscard]] constexpr Color color(SymbolRole role) const { return colors[static_cast<std::size_t>(role)]; }
};

/// Two roles of signs whose colors may be alike, because shape or text tells them apart.
struct RolesToldApart {
    SymbolRole first = SymbolRole::scale, second = SymbolRole::scale;
    base::FixedString<127> by;  ///< what tells them apart
};
inline constexpr std::size_t kMaxRolesToldApart = 6;

/// A palette file. Without one, the standard palette, which is the shipped file.
struct SymbologyPalettes {
    base::FixedString<31> name;
    std::array<SymbologyPalette, 2> lights;  ///< by SymbologyLight
    base::FixedVector<RolesToldApart, kMaxRolesToldApart> told_apart;

    [[nodiscard]] const SymbologyPalette& of(SymbologyLight light) const { return lights[static_cast<std::size_t>(light)]; }
    [[nodiscard]] SymbologyPalette& of(SymbologyLight light) { return lights[static_cast<std::size_t>(light)]; }
    [[nodiscard]] bool are_told_apart(SymbolRole first, SymbolRole second) const;
};
static_assert(std::is_trivially_copyable_v<SymbologyPalettes>);

/// That of the day, for symbols that are drawn without a palette file.
extern const SymbologyPalette kDaySymbology;
[[nodiscard]] const SymbologyPalettes& standard_symbology_palettes() noexcept;

/// Reads a palette file; `text` is its content, `file_name` its name in error messages. Refused are: a role without a color in
/// one of the lights, colors of signs and of the rim that are translucent, sizes out of their range, values that are smaller than
/// labels, unknown roles and keys.
[[nodiscard]] base::Result<SymbologyPalettes, base::Error> load_symbology_palettes(std::string_view text,
                                                                                   std::string_view file_name);

}  // namespace tedavis::design
