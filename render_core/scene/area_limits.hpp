/// The vertical limits of an area, and their text as charts write it. Pure functions; any thread.
#pragma once

#include <limits>

#include "render_core/base/display_units.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

/// A height above a datum.
struct HeightLimit {
    double m = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not stated
    HeightDatum datum = HeightDatum::msl;
};
struct AreaLimits {
    HeightLimit floor, ceiling;
};

/// Reads the attributes "floor" and "ceiling" with their "floor_datum" and "ceiling_datum" (default: the layer's datum); a
/// "height" alone is a ceiling above the ground.
[[nodiscard]] AreaLimits area_limits(const Layer& layer, std::uint32_t feature);

/// Writes limits in the unit of heights, metres with their letter, or in flight levels for the standard pressure: "GND-2600 MSL",
/// "1500 AGL-FL065", "GND-792M MSL"; "?" means not stated. Empty where neither is stated.
using LimitsText = base::FixedString<31>;
[[nodiscard]] LimitsText limits_text(const Layer& layer, std::uint32_t feature, base::DisplayUnits units);

}  // namespace tedavis::scene
