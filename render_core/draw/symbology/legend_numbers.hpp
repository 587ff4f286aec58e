/// Numbers at the scales of legends. Pure; any thread.
#pragma once

#include "render_core/draw/symbology/data_legend.hpp"
#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

/// The ends of a scale, in its own unit.
[[nodiscard]] double lowest(const design::DataScale& scale) noexcept;
[[nodiscard]] double highest(const design::DataScale& scale) noexcept;
/// Returns the number that is displayed for a value of the scale.
[[nodiscard]] double written(const DataLegend& legend, double value) noexcept;

/// The least of 1, 2, 5 times a power of ten that is not below `least`.
[[nodiscard]] double nice_step(double least) noexcept;
/// Returns the number with as many decimals as multiples of `step` need, at most three, because limits that are round in one unit
/// are rarely round in another.
[[nodiscard]] ShortText number_text(double value, double step) noexcept;
/// "+1000", "-500", "0".
[[nodiscard]] ShortText signed_number(double value) noexcept;

}  // namespace tedavis::draw
