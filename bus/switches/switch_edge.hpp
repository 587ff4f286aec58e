/// A level change of a phase switch line with its time. Levels are logical: the source inverts active-low lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxSwitchLines = 16;

/// "At `time` the line was seen at `level`." The first edge of a line is its level at start; a repeated level (read again after
/// an overrun) changes nothing.
struct SwitchEdge {
    base::Time time;        ///< source time, from the kernel's stamp
    std::uint8_t line = 0;  ///< index in the switch config's list of lines
    bool level = false;
};
static_assert(std::is_trivially_copyable_v<SwitchEdge>);

/// Levels of all lines at one instant, one bit a line.
struct SwitchLevels {
    std::uint32_t known = 0;  ///< lines with at least one edge so far
    std::uint32_t high = 0;   ///< a subset of known

    friend constexpr bool operator==(SwitchLevels a, SwitchLevels b) { return a.known == b.known && a.high == b.high; }
    friend constexpr bool operator!=(SwitchLevels a, SwitchLevels b) { return !(a == b); }
};

}  // namespace tedavis::bus
