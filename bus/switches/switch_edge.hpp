/// A level that a phase switch line took, and when. Levels are logical: active-low lines are turned round by the source.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::bus {

inline constexpr std::size_t kMaxSwitchLines = 16;

/// "At `time` the line was seen at `level`." The first edge of a line is its level at start; a level that is stated again
/// (read again after an overrun) changes nothing.
struct SwitchEdge {
    base::Time time;        ///< source time, from the kernel's stamp
    std::uint8_t line = 0;  ///< place in the switch config's list of lines
    bool level = false;
};
static_assert(std::is_trivially_copyable_v<SwitchEdge>);

/// Levels of all lines at one instant, one bit a line.
struct SwitchLevels {
    std::uint32_t known = 0;  ///< lines of which any level has been seen
    std::uint32_t high = 0;   ///< a subset of known

    friend constexpr bool operator==(SwitchLevels a, SwitchLevels b) { return a.known == b.known && a.high == b.high; }
    friend constexpr bool operator!=(SwitchLevels a, SwitchLevels b) { return !(a == b); }
};

}  // namespace tedavis::bus
