/// The payload lengths of CAN FD (ISO 11898-1): 0..8, 12, 16, 20, 24, 32, 48, 64 bytes.
#pragma once

#include <cstddef>

namespace tedavis::bus {

[[nodiscard]] constexpr bool is_fd_length(std::size_t bytes) {
    if (bytes <= 8) return true;
    return bytes <= 24 ? bytes % 4 == 0 : bytes == 32 || bytes == 48 || bytes == 64;
}

}  // namespace tedavis::bus
