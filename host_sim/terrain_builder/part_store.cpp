#include "host_sim/terrain_builder/part_store.hpp"

#include <zlib.h>

namespace tedavis::host_sim {

std::uint32_t checksum(const void* bytes, std::size_t count) {
    return static_cast<std::uint32_t>(crc32_z(0, static_cast<const Bytef*>(bytes), count));
}

}  // namespace tedavis::host_sim
