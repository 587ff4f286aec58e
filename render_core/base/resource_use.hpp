/// The fill level of a resource with a fixed capacity. Every arena, pool, queue and cache reports it; the frame record, the
/// reports and the tests read it.
#pragma once

#include <cstdint>
#include <type_traits>

namespace tedavis::base {

struct ResourceUse {
    std::uint64_t capacity = 0;
    std::uint64_t in_use = 0;
    std::uint64_t high_water = 0;
    std::uint64_t refused = 0;  ///< requests refused because it was full

    void take(std::uint64_t amount) {
        in_use += amount;
        if (in_use > high_water) high_water = in_use;
    }
};
static_assert(std::is_trivially_copyable_v<ResourceUse>);

}  // namespace tedavis::base
