/// What an area reaches from and to, and how charts write that. Pure functions; any thread.
#pragma once

#include <limits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

/// A height over something.
struct HeightLimit {
    double m = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not stated
    HeightDatum datum = HeightDatum::msl;
};
struct AreaLimits {
    HeightLimit floor, ceiling;
};

/// By the attributes "floor" and "ceiling" with "floor_datum" and "ceiling_datum", where these are not there of the layer's
/// datum; a "height" alone is a ceiling over the ground.
[[nodiscard]] AreaLimits area_limits(const Layer& layer, std::uint32_t feature);

/// In feet, or flight levels over the standard pressure: "GND-2600 MSL", "1500 AGL-FL065"; "?" is not stated. Empty where neither
/// is.
using LimitsText = base::FixedString<31>;
[[nodiscard]] LimitsText limits_text(const Layer& layer, std::uint32_t feature);

}  // namespace tedavis::scene
