/// Colours of values of spatial data: a palette as it is, or in classes.
///
/// Values are in the unit of the scene's attribute. Pure functions but for the reader; any thread.
#pragma once

#include <cstddef>
#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/palette.hpp"

namespace tedavis::design {

inline constexpr std::size_t kMaxClasses = 16;

/// A palette over values, as it is or in classes.
struct DataScale {
    Palette palette;
    /// Limits between classes, ascending; classes are half open, a value on a limit belongs to the class above it. Empty:
    /// continuous.
    base::FixedVector<double, kMaxClasses - 1> breaks;
};

/// The class of a value, 0 .. breaks.size(); of a continuous scale 0. NaN is in the lowest: ask first whether it is missing.
[[nodiscard]] std::size_t class_of(const DataScale& scale, double value) noexcept;
/// Of a class, 0 .. breaks.size(): the palette's at its middle, at its only limit's side for the first and the last.
[[nodiscard]] Color color_of_class(const DataScale& scale, std::size_t number) noexcept;
/// Of a value, by its class where the scale has classes.
[[nodiscard]] Color scale_color(const DataScale& scale, double value) noexcept;

/// As few classes as `most`, 2 or more: every second limit, or third, of those that there are; equal steps where there are none.
/// A nominal palette stays as it is: its classes cannot be joined.
void reduce_classes(DataScale& scale, std::size_t most) noexcept;

/// Keys of a scale in a section: "palette", "classes" and "breaks", or others of their kind.
struct ScaleKeys {
    std::string_view palette = "palette", classes = "classes", breaks = "breaks";
};
/// The palette is a must; a nominal one has classes of its own.
void read_scale(base::ConfigSection& section, PaletteSource& palettes, DataScale& scale, const ScaleKeys& keys = {});

}  // namespace tedavis::design
