/// The place of the lowest bit that is set; one must be.
#pragma once

#include <cstdint>

namespace tedavis::raytrace {

[[nodiscard]] inline std::uint32_t lowest_bit(std::uint64_t bits) { return static_cast<std::uint32_t>(__builtin_ctzll(bits)); }

}  // namespace tedavis::raytrace
