/// Returns the index of the lowest set bit; the argument must not be 0.
#pragma once

#include <cstdint>

namespace tedavis::raytrace {

[[nodiscard]] inline std::uint32_t lowest_bit(std::uint64_t bits) { return static_cast<std::uint32_t>(__builtin_ctzll(bits)); }

}  // namespace tedavis::raytrace
