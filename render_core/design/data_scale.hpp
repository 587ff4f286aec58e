/// Colour scales for values of spatial data: a palette, continuous or in classes.
///
/// Values are in the unit of the scene's attribute. Pure functions, except the reader; any thread.
#pragma once

#include <cstddef>
#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/palette.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxClasses = 16;

/// A palette over values, continuous or in classes.
struct DataScale {
    Palette palette;
    /// Limits between classes, ascending; classes are half open, a value on a limit belongs to the class above it. Empty:
    /// continuous.
    base::FixedVector<double, kMaxClasses - 1> breaks;
};

/// Returns the class of a value, 0 .. breaks.size(); 0 for a continuous scale. NaN is put in the lowest class: check first
/// whether the value is missing.
[[nodiscard]] std::size_t class_of(const DataScale& scale, double value) noexcept;
/// Returns the colour of a class, 0 .. breaks.size(): the palette's at the class's middle; for the first and the last class at
/// their only limit.
[[nodiscard]] Color color_of_class(const DataScale& scale, std::size_t number) noexcept;
/// Returns the colour of a value, or of its class where the scale has classes.
[[nodiscard]] Color scale_color(const DataScale& scale, double value) noexcept;

/// Reduces a scale to at most `most` classes (2 or more): keeps every second or third limit; a continuous scale gets equal
/// steps. A nominal palette is unchanged, because its classes cannot be joined.
void reduce_classes(DataScale& scale, std::size_t most) noexcept;

/// The names of a scale's keys in a section: "palette", "classes" and "breaks", or their counterparts with a prefix.
struct ScaleKeys {
    std::string_view palette = "palette", classes = "classes", breaks = "breaks";
};
/// Reads a scale. The palette is required; a nominal palette defines its own classes.
void read_scale(base::ConfigSection& section, PaletteSource& palettes, DataScale& scale, const ScaleKeys& keys = {});

}  // namespace tedavis::design
