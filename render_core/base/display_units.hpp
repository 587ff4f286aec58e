/// The units that the display writes. One setting of a design is for all that it writes of itself: tapes, readouts, legends,
/// labels and maps. What charts and the field write in one unit whatever the display's are (flight levels, wind barbs of 5 and 10
/// knots, spacings as the design states them, data in metres) stays in it.
///
/// Pure; any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/units.hpp"

namespace tedavis::base {

enum class DisplayUnits : std::uint8_t {
    feet_and_knots,  ///< feet, knots, feet per minute, nautical miles
    metric,          ///< metres, kilometres per hour, metres per second, kilometres
};

struct DisplayUnit {
    double si = 1;  ///< metres, or metres per second, of one of it
    std::string_view text;

    /// The number to be written for a value in SI.
    [[nodiscard]] constexpr double of(double value) const { return value / si; }
};

[[nodiscard]] constexpr DisplayUnit height_unit(DisplayUnits units) noexcept {
    return units == DisplayUnits::metric ? DisplayUnit{1, "M"} : DisplayUnit{kMetresPerFoot, "FT"};
}
/// Of speeds along the ground or through the air.
[[nodiscard]] constexpr DisplayUnit speed_unit(DisplayUnits units) noexcept {
    return units == DisplayUnits::metric ? DisplayUnit{kMpsPerKilometreAnHour, "KM/H"} : DisplayUnit{kMpsPerKnot, "KT"};
}
[[nodiscard]] constexpr DisplayUnit vertical_speed_unit(DisplayUnits units) noexcept {
    return units == DisplayUnits::metric ? DisplayUnit{1, "M/S"} : DisplayUnit{kMpsPerFootPerMinute, "FT/MIN"};
}
[[nodiscard]] constexpr DisplayUnit distance_unit(DisplayUnits units) noexcept {
    return units == DisplayUnits::metric ? DisplayUnit{1000, "KM"} : DisplayUnit{kMetresPerNauticalMile, "NM"};
}

}  // namespace tedavis::base
