/// What the display explains of its colors and symbols, as a pilot, a bus or a program asks for it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tedavis::flight {

enum class LegendShow : std::uint8_t {
    none,   ///< nothing, but the name of a member that is shown in turn with others
    key,    ///< a small key of the scales that do not explain themselves
    whole,  ///< every color, scale and symbol, in columns beside the attitude
};
/// Names in options and files, in the order of the values; a value is also the code on the bus.
inline constexpr std::array<std::string_view, 3> kLegendShowNames = {"none", "key", "whole"};

[[nodiscard]] constexpr std::string_view name_of(LegendShow show) { return kLegendShowNames[static_cast<std::size_t>(show)]; }

}  // namespace tedavis::flight
